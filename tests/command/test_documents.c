/* --help, the man page and the completions name the options that the command takes: those of its
 * table, neither more nor fewer. Both completions offer the same values, and the command takes
 * them. Colours are for terminals. */
#define _XOPEN_SOURCE 700
#include "runner.h"

#include <ctype.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "options.h"
#include "report.h"

#define MANUAL "tools/gnomon/gnomon.1"
#define BASH "tools/gnomon/completion/gnomon.bash"
#define ZSH "tools/gnomon/completion/_gnomon"

static const command commands[] = {COMMAND_RENDER, COMMAND_COMPARE, COMMAND_DEMO, COMMAND_SPIN,
                                   COMMAND_VIEW,   COMMAND_DIFF,    COMMAND_INFO, COMMAND_EXPLAIN};
#define COMMAND_COUNT (sizeof commands / sizeof commands[0])

/* Names of long options, without dashes, in any order. */
typedef struct names {
    char name[200][24];
    int count;
} names;

static bool has(const names *n, const char *name)
{
    for (int i = 0; i < n->count; ++i)
        if (strcmp(n->name[i], name) == 0)
            return true;
    return false;
}

static void add(names *n, const char *name, size_t length)
{
    char copy[24];
    assert_true(length < sizeof copy && n->count < 200);
    snprintf(copy, sizeof copy, "%.*s", (int)length, name);
    if (!has(n, copy))
        strcpy(n->name[n->count++], copy);
}

/* The names after this prefix, which stands at the beginning of a word. */
static names names_in(const char *text, const char *prefix)
{
    names result = {.count = 0};
    for (const char *at = text; (at = strstr(at, prefix)) != NULL;) {
        const bool begins = at == text || strchr(" \n,(*'[\"", at[-1]) != NULL;
        at += strlen(prefix);
        size_t length = 0;
        while (islower((unsigned char)at[length]) || at[length] == '-')
            ++length;
        if (begins && length > 0)
            add(&result, at, length);
        at += length;
    }
    return result;
}

static names options_of(command which)
{
    names result = {.count = 0};
    const char *name;
    for (size_t i = 0; (name = options_name(which, i)) != NULL; ++i)
        add(&result, name, strlen(name));
    assert_true(result.count > 3);
    return result;
}

static void expect_all(const names *wanted, const names *found, const char *where)
{
    for (int i = 0; i < wanted->count; ++i)
        if (!has(found, wanted->name[i]))
            fail_msg("%s lacks --%s", where, wanted->name[i]);
}

static void expect_equal(const names *wanted, const names *found, const char *where)
{
    expect_all(wanted, found, where);
    for (int i = 0; i < found->count; ++i)
        if (!has(wanted, found->name[i]))
            fail_msg("%s has --%s, which is no option", where, found->name[i]);
}

static char root[PATH_MAX];

/* A file of the project, as text. */
static const char *text_of(const char *name)
{
    static char text[1 << 17];
    char path[PATH_MAX + 64];
    snprintf(path, sizeof path, "%s/%s", root, name);
    FILE *file = fopen(path, "r");
    if (file == NULL)
        fail_msg("%s cannot be read", path);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    return text;
}

/* Runs a line of shell that finds the project in $ROOT. */
static run in_project(const char *line)
{
    char full[PATH_MAX + 3072];
    snprintf(full, sizeof full, "ROOT='%s'; %s", root, line);
    return shell(full);
}

static void help_names_all_options(void **state)
{
    (void)state;
    for (size_t i = 0; i < COMMAND_COUNT; ++i) {
        names taken = options_of(commands[i]);
        const char *name = options_command_name(commands[i]);
        const bool has_all = has(&taken, "help-all");
        char where[64];
        for (int all = 0; all <= has_all; ++all) {
            run r = gnomon("%s --help%s", name, all ? "-all" : "");
            names found = names_in(r.out, "--");
            snprintf(where, sizeof where, "gnomon %s --help%s", name, all ? "-all" : "");
            assert_int_equal(r.status, 0);
            if (!all)
                assert_non_null(strstr(r.out, "xit status"));
            /* Mentioned in texts about other things. */
            add(&found, "help", 4);
            add(&found, "help-all", 8);
            if (!has_all)
                add(&taken, "help-all", 8);
            /* The short text of view names some options of render. */
            if (commands[i] != COMMAND_VIEW || all)
                expect_equal(&taken, &found, where);
        }
    }
}

static void the_manual_names_all_options(void **state)
{
    (void)state;
    names all = {.count = 0};
    names found = names_in(text_of(MANUAL), "Fl -");
    names inside = names_in(text_of(MANUAL), ", -");
    for (int i = 0; i < inside.count; ++i)
        add(&found, inside.name[i], strlen(inside.name[i]));
    for (size_t i = 0; i < COMMAND_COUNT; ++i) {
        names taken = options_of(commands[i]);
        for (int k = 0; k < taken.count; ++k)
            add(&all, taken.name[k], strlen(taken.name[k]));
    }
    add(&all, "version", 7);
    add(&all, "matrices", 8);
    expect_equal(&all, &found, MANUAL);
    for (size_t i = 0; i < COMMAND_COUNT; ++i) {
        char line[64];
        snprintf(line, sizeof line, "\n.It Cm %s\n", options_command_name(commands[i]));
        assert_non_null(strstr(text_of(MANUAL), line));
    }
    assert_non_null(strstr(text_of(MANUAL), ".Sh EXIT STATUS"));
}

/* Whether the program exists; otherwise says what is skipped. */
static bool present(const char *program, const char *what)
{
    char line[128];
    snprintf(line, sizeof line, "command -v %s", program);
    if (shell(line).status == 0)
        return true;
    print_message("skipped: %s: %s is absent: 'make setup' installs it\n", what, program);
    return false;
}

static void the_manual_is_well_formed(void **state)
{
    (void)state;
    if (!present("mandoc", "the man page is not checked"))
        return;
    run r = in_project("mandoc -T lint -W warning \"$ROOT/" MANUAL "\"");
    if (r.status != 0)
        fail_msg("%s%s", r.out, r.error);
    r = in_project("mandoc -T utf8 \"$ROOT/" MANUAL
                   "\" | sed 's,.\\x08,,g' | grep -c -e --no-depth-test");
    assert_int_equal(r.status, 0);
}

/* What bash offers for the last of these words. */
static run offered(const char *words, int count)
{
    char line[1024];
    snprintf(line, sizeof line,
             "bash -c 'source \"$1\"; complete -p gnomon >/dev/null || exit 9; COMP_WORDS=(%s); "
             "COMP_CWORD=%d; _gnomon; echo \" ${COMPREPLY[*]} \"' bash \"$ROOT/" BASH "\"",
             words, count);
    return in_project(line);
}

static void expect_offered(const char *words, int count, const char *text)
{
    run r = offered(words, count);
    if (r.status != 0 || r.error[0] != '\0' || strcmp(r.out, text) != 0)
        fail_msg("%s: offered '%s', not '%s' %s", words, r.out, text, r.error);
}

static void bash_completes(void **state)
{
    (void)state;
    if (!present("bash", "completion is not tested"))
        return;
    for (size_t i = 0; i < COMMAND_COUNT; ++i) {
        char words[64];
        names taken = options_of(commands[i]);
        snprintf(words, sizeof words, "gnomon %s --", options_command_name(commands[i]));
        run r = offered(words, 2);
        assert_int_equal(r.status, 0);
        names found = names_in(r.out, "--");
        expect_equal(&taken, &found, words);
    }
    expect_offered("gnomon re", 1, " render \n");
    expect_offered("gnomon transform --m", 2, " --matrices \n");
    expect_offered("gnomon render --sha", 2, " --shader --shadows \n");
    expect_offered("gnomon render a.obj --shader bl", 4, " blinn-phong \n");
    expect_offered("gnomon render --shader = t", 4, " toon \n");
    expect_offered("gnomon spin --axis \"\"", 3, " x y z \n");
    expect_offered("gnomon render a.o", 2, "  \n");
    expect_offered("gnomon render --texture a.p", 3, "  \n");
}

/* The options of a command for zsh. The functions that its completion calls are replaced by ones
 * that print what they get. */
static run described(command which)
{
    char line[512];
    snprintf(
        line, sizeof line,
        "zsh -f -c '_arguments() { print -l -- \"$@\"; }; _describe() { :; }; words=(gnomon %s "
        "--); CURRENT=3; source \"$1\"' zsh \"$ROOT/" ZSH "\"",
        options_command_name(which));
    run r = in_project(line);
    if (r.status != 0 || r.error[0] != '\0')
        fail_msg("%s: status %d, %s", line, r.status, r.error);
    return r;
}

static void zsh_completes(void **state)
{
    (void)state;
    if (!present("zsh", "completion of zsh is not tested"))
        return;
    for (size_t i = 0; i < COMMAND_COUNT; ++i) {
        const char *name = options_command_name(commands[i]);
        names taken = options_of(commands[i]);
        run r = described(commands[i]);
        names found = names_in(r.out, "--");
        names after = names_in(r.out, ")--");
        for (int k = 0; k < after.count; ++k)
            add(&found, after.name[k], strlen(after.name[k]));
        expect_equal(&taken, &found, name);
    }
    run r = in_project("zsh -f -c '_arguments() { print -l -- \"$@\"; }; _describe() { print -l -- "
                       "$commands; }; words=(gnomon x); CURRENT=2; source \"$1\"' zsh \"$ROOT/" ZSH
                       "\"");
    assert_int_equal(r.status, 0);
    for (size_t i = 0; i < COMMAND_COUNT; ++i)
        assert_non_null(strstr(r.out, options_command_name(commands[i])));
    assert_non_null(strstr(r.out, "transform:"));
}

/* The values that bash offers for each option of a command: lines such as "--cull back front". */
static run values_in_bash(command which)
{
    char line[2048];
    int at = snprintf(line, sizeof line, "bash -c 'source \"$1\"; for option in");
    const names taken = options_of(which);
    for (int i = 0; i < taken.count; ++i)
        at += snprintf(line + at, sizeof line - (size_t)at, " --%s", taken.name[i]);
    snprintf(line + at, sizeof line - (size_t)at,
             "; do COMP_WORDS=(gnomon %s $option \"\"); COMP_CWORD=3; _gnomon; "
             "echo \"$option ${COMPREPLY[*]}\"; done' bash \"$ROOT/" BASH "\"",
             options_command_name(which));
    run r = in_project(line);
    if (r.status != 0 || r.error[0] != '\0')
        fail_msg("%s: status %d, %s", line, r.status, r.error);
    return r;
}

/* The words of a list behind an option, which ends its line; in zsh's text it stands between
 * brackets, after "--cull[which side]:side:". */
static names values_of(const char *text, const char *option, bool is_zsh)
{
    names result = {.count = 0};
    char start[32];
    snprintf(start, sizeof start, "--%s%s", option, is_zsh ? "[" : " ");
    const char *at = strstr(text, start);
    if (at == NULL)
        return result;
    const char *end = at + strcspn(at, "\n");
    for (at += strlen(start); is_zsh && at < end && (at[-1] != ':' || *at != '(');)
        ++at;
    while (at < end) {
        const size_t blank = strspn(at, " ()"), length = strcspn(at + blank, " )\n");
        if (length > 0)
            add(&result, at + blank, length);
        at += blank + length;
    }
    return result;
}

static char said[1024];

static void keep_line(const char *line)
{
    snprintf(said, sizeof said, "%s", line);
}

/* The exit status of a command line that is right but for the value of the option. */
static int status_with(command which, const char *option, const char *value)
{
    static options o;
    char arguments[8][32];
    char *argv[8];
    int argc = 1, status = 0;
    snprintf(arguments[0], sizeof arguments[0], "%s", options_command_name(which));
    for (int i = which == COMMAND_DEMO ? 2 : which == COMMAND_DIFF ? 0 : 1; i < 2; ++i)
        strcpy(arguments[argc++], "a.obj");
    if (which == COMMAND_DEMO)
        strcpy(arguments[argc++], "--shader=phong");
    if (which == COMMAND_EXPLAIN)
        strcpy(arguments[argc++], "--pixel=0,0");
    else
        strcpy(arguments[argc++], strcmp(option, "format") == 0 ? "--output=a" : "--output=a.png");
    snprintf(arguments[argc++], sizeof arguments[0], "--%s", option);
    snprintf(arguments[argc++], sizeof arguments[0], "%s", value);
    for (int i = 0; i < argc; ++i)
        argv[i] = arguments[i];
    report_to(keep_line);
    options_parse(which, argc, argv, &o, &status);
    report_to(NULL);
    return status;
}

/* A back end may be absent here: that is no fault of the command line. */
static void expect_values_taken(command which, const char *option, const names *offered)
{
    for (int i = 0; i < offered->count; ++i) {
        const char *value = offered->name[i];
        if (status_with(which, option, value) == EXIT_USAGE)
            fail_msg("offered for %s --%s: %s", options_command_name(which), option, said);
        assert_int_equal(status_with(which, option, "?"), EXIT_USAGE);
        if (strstr(said, value) == NULL)
            fail_msg("%s --%s lacks %s: %s", options_command_name(which), option, value, said);
    }
}

static void expect_same_values(const names *in_bash, const names *in_zsh, const char *where)
{
    for (int i = 0; i < in_bash->count; ++i)
        if (!has(in_zsh, in_bash->name[i]))
            fail_msg("%s lacks %s, which bash offers", where, in_bash->name[i]);
    for (int i = 0; i < in_zsh->count; ++i)
        if (!has(in_bash, in_zsh->name[i]))
            fail_msg("%s has %s, which bash does not offer", where, in_zsh->name[i]);
}

static void completed_values_are_taken(void **state)
{
    int count = 0;
    (void)state;
    if (!present("bash", "values are not compared") || !present("zsh", "values are not compared"))
        return;
    for (size_t i = 0; i < COMMAND_COUNT; ++i) {
        const names taken = options_of(commands[i]);
        const run bash = values_in_bash(commands[i]), zsh = described(commands[i]);
        for (int k = 0; k < taken.count; ++k) {
            char where[64];
            const char *option = taken.name[k];
            const names in_bash = values_of(bash.out, option, false);
            const names in_zsh = values_of(zsh.out, option, true);
            snprintf(where, sizeof where, "%s of %s --%s", ZSH, options_command_name(commands[i]),
                     option);
            expect_same_values(&in_bash, &in_zsh, where);
            expect_values_taken(commands[i], option, &in_bash);
            count += in_bash.count;
        }
    }
    assert_true(count > 150);
}

/* Limits that only show when they are met. */
static void limits_are_told(void **state)
{
    static const struct {
        char arguments[24];
        char text[48];
    } told[] = {
        {"render --help-all", "--statistics is refused with --views"},
        {"render --help-all", "at most 64"},
        {"info --help", "at most 64"},
        {"render --help-all", "replaces --orthographic"},
        {"spin --help", "1 to 1000"},
    };
    char words[256] = "";
    (void)state;
    for (size_t i = 0; i < sizeof told / sizeof told[0]; ++i) {
        run r = gnomon("%s", told[i].arguments);
        if (strstr(r.out, told[i].text) == NULL)
            fail_msg("gnomon %s lacks '%s'", told[i].arguments, told[i].text);
    }
    assert_non_null(strstr(text_of(MANUAL), "at most 64"));
    assert_non_null(strstr(text_of(MANUAL), "an impossible value"));
    for (int i = 0; i < OPTIONS_MAX_MODELS; ++i)
        strcat(words, " a");
    run r = gnomon("info%s", words);
    assert_int_equal(r.status, 1);
    r = gnomon("info%s a", words);
    assert_int_equal(r.status, 2);
    assert_non_null(strstr(r.error, "more than 64 files"));
}

/* A terminal is made by `script`. */
static void errors_are_coloured_on_terminals(void **state)
{
    static const char red[] = "\033[1;31mgnomon: nothing.obj: cannot be read: No such file or "
                              "directory\033[0m";
    (void)state;
    run r = gnomon("render nothing.obj -o a.png");
    assert_null(strchr(r.error, '\033'));
    if (!present("script", "colours are not tested"))
        return;
    r = shell("TERM=xterm script -qec '\"$GNOMON\" render nothing.obj -o a.png' /dev/null");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.out, red));
    r = shell(
        "NO_COLOR=1 TERM=xterm script -qec '\"$GNOMON\" render nothing.obj -o a.png' /dev/null");
    assert_non_null(strstr(r.out, "gnomon: nothing.obj"));
    assert_null(strchr(r.out, '\033'));
    r = shell("TERM=dumb script -qec '\"$GNOMON\" render nothing.obj -o a.png' /dev/null");
    assert_null(strchr(r.out, '\033'));
    r = shell("TERM=xterm script -qec '\"$GNOMON\" paint' /dev/null");
    assert_int_equal(r.status, 2);
    assert_non_null(strstr(r.out, "\033[1;31m"));
    r = shell("TERM=xterm script -qec '\"$GNOMON\" render nothing.obj -o a.png 2>kept; cat kept' "
              "/dev/null");
    assert_null(strchr(r.out, '\033'));
    write_text("square.obj", square_obj);
    r = shell(
        "TERM=xterm script -qec '\"$GNOMON\" render square.obj -o a.png --size 8x8 --near 99' "
        "/dev/null");
    assert_non_null(strstr(r.out, "\033[1;35mgnomon: a.png: warning: "));
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(help_names_all_options),
        cmocka_unit_test(the_manual_names_all_options),
        cmocka_unit_test(the_manual_is_well_formed),
        cmocka_unit_test(bash_completes),
        cmocka_unit_test(zsh_completes),
        cmocka_unit_test(completed_values_are_taken),
        cmocka_unit_test(limits_are_told),
        cmocka_unit_test(errors_are_coloured_on_terminals),
    };
    if (realpath(".", root) == NULL)
        return 2;
    runner_start(argc, argv);
    int failed = cmocka_run_group_tests_name("command, documents", tests, NULL, NULL);
    runner_end();
    return failed != 0;
}
