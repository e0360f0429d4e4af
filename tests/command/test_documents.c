/* What is written from the tables of commands and options: --help, the man page and the completions
 * have all options, shells run the completions, and the command takes the values that they offer.
 */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "command_table.h"
#include "option_table.h"

/* Fails unless the text has every option of these commands that --help has; if it is a list, every
 * option and no others. */
static void expect_options(int commands, const char *text, bool is_list, const char *where)
{
    for (const option_row *row = option_table; row < option_table + option_count; ++row) {
        char option[32];
        bool wanted = false, found = false;
        const size_t length = (size_t)snprintf(option, sizeof option, "--%s", row->name);
        for (size_t i = 0; i < option_count; ++i)
            wanted |= strcmp(option_table[i].name, row->name) == 0 &&
                      (option_table[i].commands & commands) != 0;
        for (const char *at = text; (at = strstr(at, option)) != NULL; at += length)
            found |= !islower((unsigned char)at[length]) && at[length] != '-';
        if (row->value.kind != OPTION_HEADING && found != wanted &&
            (is_list || (row->brief != NULL && wanted)))
            fail_msg("%s: --%s\n%s", where, row->name, text);
    }
}

/* A shell that finds the documents in $D. */
static run documents(const char *format, const char *words)
{
    char line[1024];
    snprintf(line, sizeof line, format, words);
    return shell("export D=$(dirname \"$GNOMON\")/documents; %s", line);
}

TEST(help_and_the_manual_have_all_options)
{
    int all = 0;
    for (size_t i = 0; i < command_count; ++i) {
        const command_row *c = command_table + i;
        const bool draws = (c->which & COMMANDS_OF_MODELS) != 0;
        all |= (int)c->which;
        for (int in_full = 0; in_full <= draws; ++in_full) {
            run r = good("%s --help%s", c->name, in_full ? "-all" : "");
            expect_options((int)c->which, r.out, false, c->name);
            expect_printed(&r, "\nExit status: 0");
            assert_true(in_full || lines(r.out) <= 45); /* it fits a screen */
            for (char *line = strtok(r.out, "\n"); line != NULL; line = strtok(NULL, "\n"))
                assert_true(strlen(line) <= 90);
        }
    }
    if (!has_program("mandoc", "the man page"))
        return;
    run r = documents("mandoc -T lint -W %s $D/gnomon.1", "warning");
    if (r.status != 0)
        fail_msg("%s%s", r.out, r.error);
    r = documents("mandoc -T utf8 $D/gnomon.1 | sed 's,.\x08,,g' | grep %s", "-e --");
    expect_options(all, r.out, false, "the man page");
}

#define BASH                                                                                       \
    "bash -c 'source $D/gnomon.bash; complete -p gnomon >&2; COMP_WORDS=(gnomon %s); "             \
    "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _gnomon; echo \"${COMPREPLY[*]}\"' 2>/dev/null"
/* The functions that the completion of zsh calls are replaced by ones that print what they get. */
#define ZSH                                                                                        \
    "zsh -f -c '_arguments() { print -l -- \"$@\"; }; _describe() { print -l -- $commands; }; "    \
    "words=(gnomon %s); CURRENT=$#words; source $D/_gnomon'"

TEST(shells_complete)
{
    static const struct {
        const char *shell, *words, *offered;
    } cases[] = {
        {BASH, "re", "render\n"},
        {BASH, "render --sha", "--shader --shadows\n"},
        {BASH, "render a.obj --shader bl", "blinn-phong\n"},
        {BASH, "render --shader = t", "toon\n"},
        {BASH, "render --format \"\"", "png tga ppm raw\n"},
        {BASH, "spin --format \"\"", "png tga ppm\n"},
        {BASH, "render --texture a.p", "\n"}, /* a file */
        {ZSH, "x", "\ndiff:count the pixels in which pictures differ\n"},
        {ZSH, "render a", "(-o --output)-o[the picture]:OUT:_files\n(-o --output)--output[the"},
        {ZSH, "demo --", "\n--filter[the filter of maps]:NAME:(mipmap linear nearest)\n"},
        {ZSH, "info a", "\n*:file:_files\n"},
    };
    if (!has_program("bash", "completion") || !has_program("zsh", "completion"))
        return;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        run r = documents(cases[i].shell, cases[i].words);
        const bool is_part = strcmp(cases[i].shell, ZSH) == 0;
        if (is_part ? strstr(r.out, cases[i].offered) == NULL : strcmp(r.out, cases[i].offered))
            fail_msg("%s: offered '%s' %s", cases[i].words, r.out, r.error);
    }
    for (size_t i = 0; i < 2 * command_count; ++i) {
        char words[32];
        const command_row *c = command_table + i / 2;
        snprintf(words, sizeof words, "%s --", c->name);
        run r = documents(i % 2 == 0 ? BASH : ZSH, words);
        assert_string_equal(r.error, "");
        expect_options((int)c->which, r.out, true, c->name);
    }
}

/* On a command line that is right but for a file. */
TEST(completed_values_are_taken)
{
    for (size_t i = 0; i < option_count * command_count; ++i) {
        const option_row *row = option_table + i / command_count;
        const command_row *c = command_table + i % command_count;
        const char *others = c->which == COMMAND_DEMO ? "--shader phong --size 8x8 --tessellation 1"
                             : c->which == COMMAND_EXPLAIN ? "none.obj --pixel 0,0"
                             : c->which == COMMAND_DIFF    ? "none.png none.png -o a"
                                                           : "none.obj -o a";
        char words[128] = "?";
        if ((row->commands & (int)c->which) == 0 || row->words == NULL ||
            strcmp(row->words, "FILE") == 0)
            continue;
        run r = gnomon("%s %s --%s='?'", c->name, others, row->name);
        assert_non_null(strstr(r.error, " '?': not "));
        snprintf(words, sizeof words, "%s", row->words);
        for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " ")) {
            assert_non_null(strstr(r.error, word));
            run taken = gnomon("%s %s --%s=%s", c->name, others, row->name, word);
            if (strstr(taken.error, "': not ") != NULL)
                fail_run(&taken);
        }
    }
}
