/* How the command ends and what it says when something is wrong: one line on
 * standard error, "gnomon: what: why". */
#ifndef REPORT_H
#define REPORT_H

/* EXIT_SUCCESS is 0; a fault of the input is 1, of the command line 2. */
enum { EXIT_FAULT = 1, EXIT_USAGE = 2 };

/* Prints the line and returns EXIT_FAULT. Line breaks and control characters in what
 * other libraries or file names bring along become spaces. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int report_fault(const char *what, const char *format, ...);

/* Prints "gnomon COMMAND: why; see ..." and returns EXIT_USAGE. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int report_usage(const char *command, const char *format, ...);

#endif
