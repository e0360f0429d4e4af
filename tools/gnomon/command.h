/* The commands. Each takes its argument list, in which argv[0] is the command's name, and returns
 * the exit status. */
#ifndef COMMAND_H
#define COMMAND_H

#include <stdbool.h>

int command_render(int argc, char **argv);
int command_compare(int argc, char **argv);
int command_demo(int argc, char **argv);
int command_diff(int argc, char **argv);
int command_explain(int argc, char **argv);
int command_info(int argc, char **argv);
int command_spin(int argc, char **argv);
int command_transform(int argc, char **argv);
int command_view(int argc, char **argv);

/* Prints the part of --help that the commands which draw models share, in one line an option, or
 * that of --help-all, in full. Not all of them have --statistics. */
void print_picture_help(bool all, bool has_statistics);

/* The last lines of --help of such a command. */
#define HELP_ENDING(name)                                                                          \
    "Models: OBJ, PLY, STL, glTF, Collada, FBX, 3DS. " name " --help-all says more.\n"

#endif
