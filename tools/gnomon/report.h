/* How the command ends and what it prints when something is wrong: one line on standard error,
 * "gnomon: what: why". */
#ifndef REPORT_H
#define REPORT_H

#include <stdio.h>

/* EXIT_SUCCESS is 0; 1 is a fault of the input, 2 a fault of the command line. */
enum { EXIT_FAULT = 1, EXIT_USAGE = 2 };

/* Lines are coloured if standard error is a terminal and NO_COLOR is not set.
 *
 * In every line that these functions print, bytes that cannot be printed (control characters and
 * bytes that are not UTF-8) become \xNN; the reason is cut at 8 KiB. */

/* Prints the line and returns EXIT_FAULT. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int report_fault(const char *what, const char *format, ...);

/* Prints "gnomon: what: warning: why". */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void report_warning(const char *what, const char *format, ...);

/* Prints "gnomon COMMAND: why; see ..." and returns EXIT_USAGE. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int report_usage(const char *command, const char *format, ...);

/* Says which of several ranks this process is: from now on lines begin "gnomon, rank 2: what", and
 * report_usage prints nothing at ranks above 0, since every rank finds the same fault. */
void report_as_rank(unsigned int number);

/* Says where in a file the faults are: from now on lines begin "gnomon: views.txt:3: what". Null:
 * nowhere. The text must live as long. */
void report_where(const char *place);

/* Prints text, escaped like lines. */
void report_print(FILE *file, const char *text);

/* Sends lines to this function instead of standard error; null: to standard error again. They are
 * not escaped and have no line end. */
typedef void report_sink(const char *line);
void report_to(report_sink *sink);

/* Prints a line that a sink received. */
void report_line(const char *line);

/* Flushes standard output, and keeps the first reason why that fails. */
void flush_output(void);

/* Flushes standard output. Returns the status, or EXIT_FAULT if output was lost, with that reason
 * printed. */
int finish_output(int status);

#endif
