/* The commands. Each takes its argument list, in which argv[0] is the command's name, and returns
 * the exit status. */
#ifndef COMMAND_H
#define COMMAND_H

#include "picture.h"

int command_render(int argc, char **argv);
int command_compare(int argc, char **argv);
int command_demo(int argc, char **argv);
int command_diff(int argc, char **argv);
int command_explain(int argc, char **argv);
int command_info(int argc, char **argv);
int command_spin(int argc, char **argv);
int command_transform(int argc, char **argv);
int command_view(int argc, char **argv);

/* What compare and demo do with a picture, which is freed: compares it with the reference's, writes
 * the comparison and, if it is asked for, the picture, and prints what differs. Returns the exit
 * status. */
int compare_picture(const options *o, const char *name, picture *p);

#endif
