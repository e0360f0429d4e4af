/* Finds the file that somebody may have meant who named one that does not exist. */
#ifndef NEAR_NAME_H
#define NEAR_NAME_H

/* Returns the name, without its folder, of the file in the folder of `path` whose name is nearest
 * to that of `path`; allocated. Near names, the nearest first:
 * - equal but for letter case, percent encoding (%20) and blanks at the end;
 * - the same without its extension, where both extensions are those of pictures;
 * - one or two characters inserted, removed or replaced, if the rest is not only the extension.
 * Among equally near names the first in the order of bytes is taken. Backslashes separate folders
 * if `path` has no slash. Returns null if the path exists, if no name is near, or if there is not
 * enough memory. Only the first 10000 entries of a folder are looked at. */
char *files_nearest(const char *path);

/* Returns the reason why a file cannot be read, with the name of a file that may have been meant.
 * Some exporters write folders of their own machine, so a file beside the model may be meant too;
 * `model_path` is null if no model names the file. The result is valid until the next call. */
const char *files_reason_with_nearest(const char *path, const char *model_path, const char *reason);

#endif
