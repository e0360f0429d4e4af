/* The commands. Each takes its argument list, in which argv[0] is the command's name, and returns
 * the exit status. */
#ifndef COMMAND_H
#define COMMAND_H

int command_render(int argc, char **argv);
int command_compare(int argc, char **argv);
int command_demo(int argc, char **argv);
int command_diff(int argc, char **argv);
int command_explain(int argc, char **argv);
int command_info(int argc, char **argv);
int command_spin(int argc, char **argv);
int command_transform(int argc, char **argv);
int command_view(int argc, char **argv);

#endif
