/* The gnomon command: the overview, and the choice of a command. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gnomon.h>

#include "command.h"
#include "confined.h"
#include "edit_distance.h"
#include "help.h"
#include "ranks.h"
#include "report.h"

static const struct {
    char name[16];
    int (*run)(int argc, char **argv);
    bool over_ranks; /* whether several ranks can do its work together */
} commands[] = {
    {"render", command_render, true},    {"compare", command_compare, false},
    {"demo", command_demo, false},       {"diff", command_diff, false},
    {"info", command_info, false},       {"spin", command_spin, true},
    {"view", command_view, false},       {"transform", command_transform, false},
    {"explain", command_explain, false},
};

/* If memory is short, a scene's allocation calls exit, and a C++ library whose exception nobody
 * catches calls abort. The user still gets a line of the command's own, and its exit status. */
static const char ended_early[] = "gnomon: probably not enough memory; ended early\n";
static bool finished;

static void explain_exit(void)
{
    if (!finished)
        fputs(ended_early, stderr);
}

static void explain_abort(int number)
{
    (void)number;
    ssize_t written = write(STDERR_FILENO, ended_early, sizeof ended_early - 1);
    (void)written;
    _exit(EXIT_FAULT);
}

/* The library's own number, the back end that draws if no option names one, and what does not hold
 * in this build. */
static int print_version(void)
{
    const unsigned int version = gn_version();
    printf("gnomon %u.%u.%u, back end %s\n", version / 1000000, version / 1000 % 1000,
           version % 1000, gn_backend_name(gn_backend_best()));
    if (!confined_limits_memory())
        puts("built with AddressSanitizer: --import-memory limits nothing");
    return finish_output(0);
}

/* Runs the command that the first word names. */
static int run_command(int argc, char **argv)
{
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; ++i)
        if (strcmp(argv[0], commands[i].name) == 0)
            return commands[i].over_ranks || ranks_count() == 1
                       ? commands[i].run(argc, argv)
                       : report_usage(argv[0], "works in one process, and %u were started",
                                      (unsigned)ranks_count());

    struct stat file;
    if (stat(argv[0], &file) == 0 && S_ISREG(file.st_mode))
        return report_usage("",
                            "'%s': no such command; to draw a file: gnomon render %s -o OUT.png",
                            argv[0], argv[0]);
    const char *meant = NULL;
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; ++i)
        meant = edit_distance_nearer(argv[0], meant, commands[i].name);
    if (meant != NULL)
        return report_usage("", "'%s': no such command; did you mean '%s'?", argv[0], meant);
    return report_usage("", "'%s': no such command", argv[0]);
}

/* Prints the overview, or the help of the command that the words name. */
static int help(int count, char **words)
{
    static char option[] = "--help";
    if (count == 0)
        return help_print_overview();
    if (count > 1)
        return report_usage("", "'%s': help is about one command", words[1]);
    char *asked[] = {words[0], option, NULL};
    return run_command(2, asked);
}

static int run(int argc, char **argv)
{
    if (argc < 2)
        return report_usage("", "no command");
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 ||
        strcmp(argv[1], "help") == 0)
        return help(argc - 2, argv + 2);
    if (strcmp(argv[1], "--version") == 0 && argc > 2)
        return report_usage("", "'%s': --version stands alone", argv[2]);
    if (strcmp(argv[1], "--version") == 0)
        return print_version();
    return run_command(argc - 1, argv + 1);
}

/* If standard input, output or error is closed, a file that is opened later would take its number
 * and be written to by mistake. /dev/null, opened for reading, takes the number instead, so that
 * writing fails. */
static void occupy_standard_files(void)
{
    for (int i = 0; i < 3; ++i)
        if (fcntl(i, F_GETFD) == -1 && open("/dev/null", O_RDONLY) < 0)
            return;
}

/* Results are printed by rank 0 alone. Returns 0, or EXIT_FAULT with the reason printed. */
static int be_rank(void)
{
    if (ranks_count() == 1)
        return 0;
    report_as_rank(ranks_number());
    if (ranks_number() > 0 && freopen("/dev/null", "w", stdout) == NULL)
        return report_fault("/dev/null", "%s", strerror(errno));
    return 0;
}

int main(int argc, char **argv)
{
    occupy_standard_files();
    int status = ranks_begin(&argc, &argv);
    if (status != 0)
        return status;
    atexit(explain_exit);
    signal(SIGABRT, explain_abort);
    signal(SIGXFSZ, SIG_IGN); /* Writing beyond a limit of files then fails with a reason. */
    status = ranks_agree(be_rank());
    if (status == 0)
        status = run(argc, argv);
    finished = true;
    return ranks_end(status);
}
