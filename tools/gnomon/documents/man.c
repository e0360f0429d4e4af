/* The man page, in the language of mdoc(7). */
#include <ctype.h>
#include <stdbool.h>
#include <string.h>

#include "command_table.h"
#include "documents.h"
#include "option_table.h"

static bool is_command(const char *word, size_t length)
{
    for (size_t i = 0; i < command_count; ++i)
        if (strlen(command_table[i].name) == length &&
            strncmp(command_table[i].name, word, length) == 0)
            return true;
    return false;
}

/* Whether the word stands in this text as it is. */
static bool stands_in(const char *word, size_t length, const char *text)
{
    for (; text != NULL && *text != '\0'; text += strcspn(text, " ."), text += strspn(text, " ."))
        if (strncmp(text, word, length) == 0 && strchr(" .]", text[length]) != NULL)
            return true;
    return false;
}

static void write_escaped(const char *text, size_t length, FILE *out)
{
    for (size_t i = 0; i < length; ++i)
        if (text[i] == '\\')
            fputs("\\e", out);
        else if (text[i] == '-')
            fputs("\\-", out);
        else
            fputc(text[i], out);
}

/* A word with the marks around it; options and commands are bold, names of arguments italic. */
static void write_word(const char *word, size_t length, bool behind_gnomon, const char *arguments,
                       FILE *out)
{
    const size_t before = strspn(word, "([") < length ? strspn(word, "([") : 0;
    const char *core = word + before;
    size_t core_length = length - before;
    if (core_length > 2 && core[0] == '-' && core[1] == '-')
        core_length = 2 + strspn(core + 2, "abcdefghijklmnopqrstuvwxyz-");
    while (core_length > 1 && strchr(".,:;)]", core[core_length - 1]) != NULL)
        --core_length;
    const bool is_bold = (core_length > 2 && core[0] == '-' && core[1] == '-') ||
                         (core_length == 2 && strncmp(core, "-o", 2) == 0) ||
                         (behind_gnomon && is_command(core, core_length));
    const bool is_italic = isupper((unsigned char)*core) && stands_in(core, core_length, arguments);
    if (word[0] == '.' || word[0] == '\'')
        fputs("\\&", out);
    write_escaped(word, before, out);
    fputs(is_bold ? "\\fB" : is_italic ? "\\fI" : "", out);
    write_escaped(core, core_length, out);
    fputs(is_bold || is_italic ? "\\fR" : "", out);
    write_escaped(core + core_length, length - before - core_length, out);
    if (length > 3 && strncmp(word + length - 3, "...", 3) == 0)
        fputs("\\&", out); /* no sentence ends */
}

static bool begins_kept(const char *text)
{
    return text != NULL && strncmp(text, "  ", 2) == 0;
}

/* A text (command_table.h), and a mark behind its last word. Sentences begin lines. */
static void write_text(const char *text, const char *mark, const char *arguments, FILE *out)
{
    bool behind_gnomon = false;
    for (const char *next; text != NULL; text = next) {
        const char *end = text + strcspn(text, "\n");
        next = *end != '\0' ? end + 1 : NULL;
        if (begins_kept(text)) {
            write_escaped(text, (size_t)(end - text), out);
            fputs(begins_kept(next) ? "\n" : "\n.Ed\n", out);
            continue;
        }
        if (text == end)
            fputs(".Pp\n", out);
        while (text < end) {
            const size_t length = strcspn(text, " \n");
            const bool is_last = text + length == end;
            write_word(text, length, behind_gnomon, arguments, out);
            fputs(is_last && next == NULL ? mark : "", out);
            fputc(is_last || (length > 1 && text[length - 1] == '.' && text[length - 2] != '.')
                      ? '\n'
                      : ' ',
                  out);
            behind_gnomon = length == 6 && strncmp(text, "gnomon", length) == 0;
            text += length + !is_last;
            if (is_last && begins_kept(next))
                fputs(".Bd -literal\n", out);
            else if (is_last && next != NULL && *next != '\n')
                fputs(".br\n", out);
        }
    }
}

/* A paragraph, unless there is no text. */
static void write_paragraph(const char *text, const char *arguments, FILE *out)
{
    if (text != NULL)
        fputs(begins_kept(text) ? ".Bd -literal\n" : ".Pp\n", out);
    write_text(text, "", arguments, out);
}

/* "render, spin and diff". */
static void write_names(int commands, FILE *out)
{
    const char *before = "";
    for (size_t i = 0; i < command_count; ++i) {
        if ((command_table[i].which & commands) == 0)
            continue;
        commands &= ~(int)command_table[i].which;
        fprintf(out, "%s%s", before, command_table[i].name);
        before = (commands & (commands - 1)) == 0 ? " and " : ", ";
    }
}

/* The item of an option, unless it is one more row of the option before. */
static void begin_item(const option_row *row, FILE *out)
{
    const char letter = option_letter(row);
    if (row[-1].value.kind != OPTION_HEADING && strcmp(row[-1].name, row->name) == 0) {
        fputs(".br\n", out);
        return;
    }
    fputs(".It ", out);
    if (letter != '\0')
        fprintf(out, "Fl %c , ", letter);
    fprintf(out, "Fl -%s", row->name);
    if (row->argument != NULL && row->argument[0] == '[')
        fprintf(out, " Ns Op = Ns Ar %.*s", (int)strlen(row->argument) - 3, row->argument + 2);
    else if (row->argument != NULL)
        fprintf(out, " Ar %s", row->argument);
    fputc('\n', out);
}

/* Below a heading, whose commands need not be named again. */
static void write_option(const option_row *row, int usual, FILE *out)
{
    const char *text = row->text != NULL ? row->text : row->brief;
    begin_item(row, out);
    if ((row->commands & usual) != usual) {
        write_names(row->commands, out);
        fputs(":\n", out);
    }
    write_text(text, ".", row->argument, out);
    if ((row->commands & ~usual) != 0 && (row->commands & usual) == usual) {
        fputs("Also for ", out);
        write_names(row->commands & ~usual, out);
        fputs(".\n", out);
    }
}

static void write_options(FILE *out)
{
    const option_row *heading = NULL;
    for (const option_row *row = option_table; row < option_table + option_count; ++row) {
        if (row->value.kind != OPTION_HEADING) {
            write_option(row, heading->commands, out);
            continue;
        }
        if (heading != NULL)
            fputs(".El\n", out);
        fprintf(out, ".Ss %s\n", row->name);
        if (row->commands != option_table[0].commands) {
            fputs("For ", out);
            write_names(row->commands, out);
            fputs(".\n", out);
        }
        write_text(row->text, "", NULL, out);
        fputs(".Bl -tag -width Ds\n", out);
        heading = row;
    }
    fputs(".El\n", out);
}

static void write_part(const command_row *c, const char *name, FILE *out)
{
    if (strcmp(name, "synopsis") == 0) {
        fprintf(out, ".Nm\n.Cm %s\n", c->name);
        write_text(c->words, "", c->words, out);
        fputs(c->which == COMMAND_TRANSFORM ? "" : ".Op Ar option ...\n", out);
    } else if (strcmp(name, "commands") == 0) {
        fprintf(out, ".It Cm %s\n", c->name);
        write_text(c->title, "", NULL, out);
    } else if (strcmp(name, "examples") == 0) {
        write_escaped(c->examples, strlen(c->examples), out);
        fputc('\n', out);
    } else {
        fprintf(out, ".Ss gnomon %s\n", c->name);
        write_text(c->usage, "", NULL, out);
        write_paragraph(c->text, c->words, out);
        write_paragraph(c->more, c->words, out);
        write_paragraph(c->which == COMMAND_RENDER ? command_drawing : NULL, NULL, out);
        fputs(".Pp\nExit status:\n", out);
        write_text(c->statuses, "", NULL, out);
    }
}

bool write_man(FILE *template, FILE *out)
{
    static const struct {
        const char *name, *text;
    } texts[] = {
        {"models", command_models}, {"results", command_results}, {"statuses", command_statuses}};
    static const char *const parts[] = {"synopsis", "commands", "examples", "texts"};
    char line[256];
    while (fgets(line, sizeof line, template) != NULL) {
        bool is_known = line[0] != '@';
        const char *name = line + 1;
        if (is_known) {
            fputs(line, out);
            continue;
        }
        line[strcspn(line, "\n")] = '\0';
        for (size_t i = 0; i < sizeof texts / sizeof texts[0]; ++i)
            if (strcmp(texts[i].name, name) == 0) {
                write_text(texts[i].text, "", NULL, out);
                is_known = true;
            }
        for (size_t i = 0; i < sizeof parts / sizeof parts[0]; ++i)
            for (size_t k = 0; k < command_count && strcmp(parts[i], name) == 0; ++k) {
                write_part(command_table + k, name, out);
                is_known = true;
            }
        if (strcmp(name, "options") == 0)
            write_options(out);
        else if (!is_known)
            return false;
    }
    return true;
}
