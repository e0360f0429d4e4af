/* How far a word is from another, to find what somebody may have meant. */
#ifndef EDIT_DISTANCE_H
#define EDIT_DISTANCE_H

/* What edit_distance returns for more than two edits. */
enum { EDIT_DISTANCE_FAR = 3 };

/* Returns how many characters must be inserted, removed or replaced to make one word of the other
 * (Levenshtein's distance); EDIT_DISTANCE_FAR if there are more than two. */
int edit_distance(const char *a, const char *b);

/* Returns the nearer of two names to a word that somebody mistyped: `best`, which may be null, or
 * `name` if that is nearer and less than half of it was edited. */
const char *edit_distance_nearer(const char *word, const char *best, const char *name);

#endif
