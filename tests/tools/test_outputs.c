/* Where pictures go: names that are refused before anything is drawn, and standard output. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void other_extensions_are_refused(void **state)
{
    static const char names[][8] = {"a.tga", "a.jpg", "a.PNG.gz", "a."};
    char line[1024];
    (void)state;
    write_text("square.obj", square_obj);
    for (int i = 0; i < 4; ++i) {
        snprintf(line, sizeof line, "render square.obj -o %s", names[i]);
        expect(1, line, names[i], "pictures are PNG files");
        snprintf(line, sizeof line, "render square.obj -o a.png --depth %s", names[i]);
        expect(1, line, names[i], "pictures are PNG files");
        snprintf(line, sizeof line, "compare square.obj -o %s", names[i]);
        expect(1, line, names[i], "pictures are PNG files");
        snprintf(line, sizeof line, "demo -o %s", names[i]);
        expect(1, line, names[i], "pictures are PNG files");
        snprintf(line, sizeof line, "demo --picture %s", names[i]);
        expect(1, line, names[i], "pictures are PNG files");
    }
    run r =
        shell("mkdir a.b; for o in a.PNG plain .hidden a.b/c; do \"$GNOMON\" render square.obj -o "
              "$o --size 8x8 && head -c 4 $o | grep -q PNG || exit 9; done");
    assert_int_equal(r.status, 0);
}

/* The name is refused before anything is printed about the picture and before the model is read. */
static void names_are_checked_first(void **state)
{
    static const char commands[][40] = {"render nothing.obj -o",
                                        "render nothing.obj -o b.png --depth",
                                        "compare nothing.obj -o", "demo -o", "demo --picture"};
    char line[1024];
    (void)state;
    assert_int_equal(mkdir(path_of("folder.png"), 0700), 0);
    for (int i = 0; i < 5; ++i) {
        snprintf(line, sizeof line, "%s nodir/x.png", commands[i]);
        expect(1, line, "nodir/x.png", "No such file");
        snprintf(line, sizeof line, "%s folder.png", commands[i]);
        expect(1, line, "folder.png", "directory");
        snprintf(line, sizeof line, "%s folder.png/x.png/y.png", commands[i]);
        expect(1, line, "folder.png/x.png/y.png", "No such file");
    }
    if (geteuid() != 0) {
        chmod(path_of("folder.png"), 0500);
        expect(1, "render nothing.obj -o folder.png/x.png", "folder.png/x.png", "Permission");
        chmod(path_of("folder.png"), 0700);
    }
}

/* Only the picture, however standard output is named; messages are on standard error. */
static void standard_output_is_the_picture(void **state)
{
    static const char lines_of_shell[][96] = {
        "\"$GNOMON\" render square.obj --size 16x16 -o - >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o - | cat >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o /dev/stdout >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o /dev/stdout | cat >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o /dev/fd/1 | cat >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o s.png >s.png"};
    (void)state;
    write_text("square.obj", square_obj);
    run r = gnomon("render square.obj --size 16x16 -o file.png");
    assert_string_equal(r.error, "");
    assert_non_null(strstr(r.out, "file.png: 16x16, 2 triangles"));
    for (size_t i = 0; i < sizeof lines_of_shell / sizeof lines_of_shell[0]; ++i) {
        char line[1024];
        remove_file("s.png");
        snprintf(line, sizeof line, "set -e; %s; cmp s.png file.png", lines_of_shell[i]);
        r = shell(line);
        if (r.status != 0 || strstr(r.error, ": 16x16, 2 triangles") == NULL || lines(r.error) != 1)
            fail_msg("%s: status %d, %s", line, r.status, r.error);
    }
    r = shell("\"$GNOMON\" compare square.obj --size 16x16 -o c.png && \"$GNOMON\" compare "
              "square.obj --size 16x16 -o - >s.png && cmp s.png c.png");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, "colour: 0 of 256"));
    assert_non_null(strstr(r.error, "colour: 0 of 256"));
    assert_non_null(strstr(r.error, "\n-: Gnomon, OSMesa, difference\n"));
    r = shell("\"$GNOMON\" demo --size 32x24 --picture p.png -o c.png && \"$GNOMON\" demo --size "
              "32x24 --picture /dev/stdout -o c2.png | cmp - p.png && cmp c.png c2.png");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.error, "depth:  0 of 768"));
    /* Only the depth. */
    r = shell(
        "\"$GNOMON\" render square.obj --size 16x16 -o d.png --depth e.png && \"$GNOMON\" render "
        "square.obj --size 16x16 -o d.png --depth - | cmp - e.png");
    assert_int_equal(r.status, 0);
    expect(1, "render square.obj -o - --depth /dev/stdout", "-", "both");
    expect(1, "demo -o /dev/stdout --picture -", "/dev/stdout", "both");
    r = shell("\"$GNOMON\" render square.obj --size 16x16 -o - >/dev/full");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "gnomon: -: cannot be written: No space"));
    assert_false(exists("-"));
}

/* Files that the command opens later must not take their numbers. */
static void standard_files_may_be_closed(void **state)
{
    (void)state;
    write_text("square.obj", square_obj);
    run r = gnomon("render square.obj -o open.png --size 16x16");
    assert_int_equal(r.status, 0);
    r = shell("\"$GNOMON\" render square.obj -o closed.png --size 16x16 <&- 2>&- && "
              "cmp open.png closed.png");
    assert_int_equal(r.status, 0);
    r = shell("\"$GNOMON\" render square.obj -o shut.png --size 16x16 <&- >&-");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "gnomon: standard output: cannot be written"));
    r = shell("cmp open.png shut.png");
    assert_int_equal(r.status, 0);
    r = shell("\"$GNOMON\" render square.obj -o - >&-");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "gnomon: -: cannot be written"));
    r = shell("\"$GNOMON\" render nothing.obj -o none.png 2>&-");
    assert_int_equal(r.status, 1);
    assert_false(exists("none.png"));
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(other_extensions_are_refused),
        cmocka_unit_test(names_are_checked_first),
        cmocka_unit_test(standard_output_is_the_picture),
        cmocka_unit_test(standard_files_may_be_closed),
    };
    runner_start(argc, argv);
    int failed = cmocka_run_group_tests_name("command, outputs", tests, NULL, NULL);
    runner_end();
    return failed != 0;
}
