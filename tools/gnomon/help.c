/* Prints the help of commands from the tables. */
#include "help.h"

#include <stdio.h>
#include <string.h>

#include "command_table.h"
#include "option_table.h"
#include "report.h"

/* Columns: where lines end, and where the texts of options begin. */
enum { WIDTH = 90, BRIEF_COLUMN = 32, FULL_COLUMN = 26, OVERVIEW_COLUMN = 41 };

/* Prints a text (command_table.h) from column `at` on, in lines that begin at `indent`. */
static void print_text(const char *text, int indent, int at)
{
    for (;;) {
        const char *end = text + strcspn(text, "\n");
        const bool is_kept = strncmp(text, "  ", 2) == 0;
        while (text < end) {
            const int length = (int)(is_kept ? (size_t)(end - text) : strcspn(text, " \n"));
            if (at > indent && at + 1 + length > WIDTH) {
                putchar('\n');
                at = 0;
            }
            at += printf("%*s%.*s", at < indent ? indent - at : at > indent, "", length, text);
            text += length + (text[length] == ' ');
        }
        putchar('\n');
        at = 0;
        if (*end == '\0')
            return;
        text = end + 1;
    }
}

static void print_paragraph(const char *text)
{
    if (text == NULL)
        return;
    print_text(text, 0, 0);
    putchar('\n');
}

/* The option that stands behind this one on its line of --help; null if there is none. */
static const option_row *next_on_line(command which, const option_row *row)
{
    const option_row *const end = option_table + option_count;
    do
        ++row;
    while (row < end && (row->commands & (int)which) == 0);
    return row < end && row->brief != NULL && row->brief[0] == '+' ? row : NULL;
}

/* Prints an option's name, and its argument unless that of `next` is the same. Returns the number
 * of columns. */
static int print_name(const option_row *row, const option_row *next)
{
    const char letter = option_letter(row);
    int at = letter != 0 ? printf("-%c, ", letter) : 0;
    at += printf("--%s", row->name);
    if (row->argument == NULL ||
        (next != NULL && next->argument != NULL && strcmp(next->argument, row->argument) == 0))
        return at;
    return at + printf("%s%s", row->argument[0] == '[' ? "" : " ", row->argument);
}

static void print_in_full(const option_row *row)
{
    int at = printf("  ") + print_name(row, NULL);
    if (at + 2 > FULL_COLUMN) {
        putchar('\n');
        at = 0;
    }
    print_text(row->text != NULL ? row->text : row->brief, FULL_COLUMN, at);
}

/* Prints the option and those on its line. Returns the last of them. */
static const option_row *print_line(command which, const option_row *row)
{
    char text[512];
    const option_row *next;
    snprintf(text, sizeof text, "%s", row->brief);
    int at = printf("  ");
    while ((next = next_on_line(which, row)) != NULL) {
        const char *own = next->brief + 1;
        at += print_name(row, next) + printf(", ");
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s", *own != '\0' ? "; " : "",
                 own);
        row = next;
    }
    at += print_name(row, NULL);
    if (at + 2 > BRIEF_COLUMN)
        at += printf("   ");
    print_text(text, BRIEF_COLUMN, at);
    return row;
}

static void print_heading(const option_row *row, bool in_full, bool is_first)
{
    if (in_full && !is_first && (row->text != NULL || row->brief != NULL))
        putchar('\n');
    if (in_full && row->text != NULL)
        print_text(row->text, 0, printf("%s.", row->name));
    else if (row->brief != NULL)
        puts(row->brief);
}

static void print_options(command which, bool in_full)
{
    bool is_first = true;
    for (const option_row *row = option_table; row < option_table + option_count; ++row) {
        if ((row->commands & (int)which) == 0)
            continue;
        if (row->value.kind == OPTION_HEADING)
            print_heading(row, in_full, is_first);
        else if (in_full && row->brief != NULL)
            print_in_full(row);
        else if (row->brief != NULL)
            row = print_line(which, row);
        is_first = is_first && row->brief == NULL;
    }
}

int help_print(command which, bool all)
{
    const command_row *c = command_row_of(which);
    const bool draws = (which & COMMANDS_OF_MODELS) != 0;
    const int at = printf("gnomon %s %s%s:", c->name, c->words,
                          which == COMMAND_TRANSFORM ? "" : " [OPTION...]");
    print_text(c->usage, 0, at);
    putchar('\n');
    print_paragraph(c->examples);
    print_paragraph(c->text);
    if (all) {
        print_paragraph(c->more);
        print_paragraph(command_models);
    }
    /* Commands without --help-all explain their few options at once. */
    print_options(which, all || !draws);
    if (all || !draws)
        putchar('\n');
    if (all)
        print_paragraph(command_drawing);
    else if (draws)
        printf("Models: OBJ, PLY, STL, glTF, Collada, FBX, 3DS. gnomon %s --help-all says more.\n",
               c->name);
    print_text(c->statuses, 0, printf("Exit status:"));
    return finish_output(0);
}

int help_print_overview(void)
{
    puts("gnomon: draws 3D models with a software renderer whose every pixel is checked.\n");
    for (const command_row *c = command_table; c < command_table + command_count; ++c)
        print_text(c->title, OVERVIEW_COLUMN, printf("  gnomon %s %s", c->name, c->words));
    puts("\ngnomon COMMAND --help, or gnomon help COMMAND, explains a command and shows examples.\n"
         "gnomon --version prints the version and the back end that draws. For a first picture:\n\n"
         "  gnomon demo --picture teapot.png\n");
    print_paragraph(command_results);
    print_text(command_statuses, 0, printf("Exit status:"));
    return finish_output(0);
}
