/* gnomon transform: setups that are refused, with their lines, and its command line. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <string.h>

/* Expects one line on standard error with both texts, and nothing on standard output. */
static void expect_error(const char *text, const char *place, const char *why)
{
    write_text("setup.txt", text);
    run r = shell("\"$GNOMON\" transform < setup.txt");
    const char *newline = strchr(r.error, '\n');
    if (r.status != 2 || r.out[0] != '\0' || strncmp(r.error, "gnomon: ", 8) != 0 ||
        newline == NULL || newline[1] != '\0' || strstr(r.error, place) == NULL ||
        strstr(r.error, why) == NULL)
        fail_msg("%s\n  status %d, expected '%s' and '%s'\n  stderr: %s  stdout: %s", text,
                 r.status, place, why, r.error, r.out);
}

#define GOOD "convention opengl\nscreen 9 9\nperspective 90\nnear 1\nfar 9\n"

TEST(errors_name_the_line)
{
    expect_error("\n# nothing\n  zoom 3 # x\n", "standard input:3: ", "'zoom' is not a statement");
    expect_error(GOOD "point 1 2\n", "standard input:6: ", "point takes 3 numbers, not 2");
    expect_error(GOOD "point 1 2 3 4\n", ":6: ", "point takes 3 numbers, not 4");
    expect_error(GOOD "point 1 x 3\n", ":6: ", "'x' is not a number");
    expect_error(GOOD "point 1 2e 3\n", ":6: ", "'2e' is not a number");
    expect_error(GOOD "point 1 1e39 3\n", ":6: ", "'1e39' is not a finite 32-bit number");
    expect_error(GOOD "point 1 nan 3\n", ":6: ", "'nan'");
    expect_error(GOOD "point 1 2 3 4 5 6 7 8 9\n", ":6: ", "too many words");
    expect_error(GOOD "scale 1 2\n", ":6: ", "scale takes 1 or 3 numbers, not 2");
    expect_error(GOOD "scale 1 0 1\npoint 1 2 3\n", ":6: ", "zero");
    expect_error(GOOD "point 1 2 3\nrotate 0 0 0 90\n",
                 ":7: ", "rotate: the direction has no length\n");
    expect_error(GOOD "near 2\n", ":6: ", "near is already in line 4");
    expect_error(GOOD "frustum -1 1 -1 1\n", ":6: ", "line 3 already has perspective");
    expect_error("convention gl\n", ":1: ", "opengl, direct3d or vulkan");
    expect_error("depth\n", ":1: ", "plain or reversed");
    expect_error("far away\n", ":1: ", "'away' is not a number");
    expect_error("", "standard input: ", "no convention");
    expect_error("convention opengl\n", "standard input: ", "no screen");
    expect_error("convention opengl\nscreen 9 9\nnear 1\nfar 9\n",
                 "standard input: ", "no perspective, orthographic or frustum");
    expect_error("convention opengl\nscreen 9 9\nnear 1\nfar infinite\northographic -1 1 -1 1\n",
                 ":4: ", "orthographic cannot be infinite");
    expect_error("convention opengl\nscreen 9 0.5\nperspective 90\nnear 1\nfar 2\n",
                 ":2: ", "1 to 16384");
    expect_error(GOOD, "standard input: ", "no point");
    expect_error(GOOD "point 1 2 3\nup 0 1 0\nright 1 0 0\n",
                 ":8: ", "right, up and forward; forward is missing\n");
    expect_error(GOOD "point 1 2 3\nright 1 0 0\n",
                 ":7: ", "right, up and forward; up and forward are missing\n");
    expect_error(GOOD "point 1 2 3\nforward 1 0 0\n",
                 ":7: ", "right, up and forward; right and up are missing\n");
    expect_error(GOOD "point 1 2 3\nforward 1 0 0\nright 1 0 0\n", ":8: ", "; up is missing\n");
    expect_error(GOOD "point 1 2 3\nforward 1 0 0\ntarget 1 1 1\n", ":8: ", "line 7");
    expect_error(GOOD "point 1 2 3\nright 1 0 0\nup 1 1 0\nforward 0 0 -1\n",
                 ":9: ", "perpendicular");
    expect_error(GOOD "point 1 2 3\nright 1 0 0\nup 0 1 0\nforward 0 0 1\n",
                 ":9: ", "right-handed");
    expect_error(GOOD "point 1 2 3\nright 1 0 0\nup 0 0 0\nforward 0 0 1\n",
                 ":8: ", "up: the direction has no length\n");
    /* The second point overflows, so nothing of the first is printed. */
    expect_error(GOOD "scale 1e30\npoint 0 0 0\npoint 1e30 0 0\n", ":8: ", "overflow");
    char text[2048];
    memset(text, ' ', sizeof text);
    strcpy(text + 1500, "\n");
    expect_error(text, ":1: ", "a line of more than");
}

TEST(views_that_do_not_exist)
{
    expect_error(GOOD "point 1 2 3\nposition 1 1 1\ntarget 1 1 1\n",
                 ":8: ", "target: it is where the camera is, in line 7\n");
    expect_error(GOOD "point 1 2 3\ntarget 0 -0 0\n",
                 ":7: ", "target: it is where the camera is, at 0 0 0\n");
    expect_error(GOOD "point 1 2 3\nup 0 0 0\ntarget 1 1 1\n",
                 ":7: ", "up: the direction has no length\n");
    expect_error(GOOD "point 1 2 3\nup 0 0 0\n", ":7: ", "up: the direction has no length\n");
    expect_error(GOOD "point 1 2 3\ntarget 0 9 0\n",
                 ":7: ", "target: the view is parallel to up, which is 0 1 0 by default\n");
    expect_error(GOOD "point 1 2 3\nup 2 2 2\ntarget -3 -3 -3\n",
                 ":8: ", "target: the view is parallel to up, in line 7\n");
    expect_error(GOOD "point 1 2 3\nup 0 0 1\n",
                 ":7: ", "up: it is parallel to the view, which is along z\n");
    expect_error(GOOD "point 1 2 3\nposition 3e38 0 0\ntarget -3e38 0 0\n", ":8: ", "range\n");
}

/* A projection with these planes, in lines 4 and 5. */
static void expect_planes(const char *projection, const char *planes, const char *place,
                          const char *why)
{
    char text[256];
    snprintf(text, sizeof text, "convention opengl\nscreen 9 9\n%s\n%s\npoint 1 2 3\n", projection,
             planes);
    expect_error(text, place, why);
}

TEST(projections_that_do_not_exist)
{
    static const char *const projections[] = {"perspective 90", "frustum -1 1 -1 1",
                                              "orthographic -1 1 -1 1"};
    for (int i = 0; i < 3; ++i) {
        const char *const p = projections[i];
        expect_planes(p, "near 9\nfar 9",
                      ":5: ", "far: it is not beyond near, which is in line 4\n");
        expect_planes(p, "far 1\nnear 5",
                      ":4: ", "far: it is not beyond near, which is in line 5\n");
        expect_planes(p, "near 1e-44\nfar 2e-44", ":3: ", "too large or too small\n");
        if (i == 2)
            break;
        expect_planes(p, "near 0\nfar 9", ":4: ", "near: it is not above 0\n");
        expect_planes(p, "near -1\nfar infinite", ":4: ", "near: it is not above 0\n");
        expect_planes(p, "near 1\nfar -9", ":5: ", "far: it is not above 0\n");
    }
    expect_planes("perspective 180", "near 1\nfar 9", ":3: ", "angle");
    expect_planes("perspective 0", "near 0\nfar 9", ":3: ", "angle");
    expect_planes("frustum 2 2 -1 1", "near 1\nfar 9",
                  ":3: ", "frustum: left and right are the same");
    expect_planes("frustum -1 1 0 0", "near 1\nfar infinite",
                  ":3: ", "frustum: bottom and top are the same");
    expect_planes("orthographic 0 0 -1 1", "near 1\nfar 9",
                  ":3: ", "orthographic: left and right are the same");
}

/* A file that is not a text is refused, whatever the lengths of its lines. A byte-order mark is not
 * part of the text. */
TEST(bytes_of_other_kinds)
{
    static char text[4096];
    for (size_t length = 900; length < 2200; length += 13) {
        strcpy(text, GOOD "# ");
        size_t start = strlen(text);
        memset(text + start, 'x', length);
        text[start] = '\0';
        strcpy(text + start + length, "rotate 0 0 1 90\npoint 1 0 -3\n");
        write_bytes("nul.txt", text, start + length + strlen(text + start + length));
        expect(2, "transform nul.txt", "nul.txt:6: ", "a NUL byte");
    }
    write_bytes("nul.txt", GOOD "point 0 0 -3\n\0point 1 0 -3\n", strlen(GOOD) + 27);
    expect(2, "transform nul.txt", "nul.txt:7: ", "a NUL byte");
    expect(2, "transform /dev/zero", "/dev/zero:1: ", "a NUL byte");
    expect(2, "transform nul.txt nul.txt", "nul.txt", "only one");

    write_text("setup.txt", GOOD "point 0 0 -3\n");
    run plain = gnomon("transform setup.txt");
    expect_good(&plain);
    write_text("setup.txt", "\xef\xbb\xbf" GOOD "point 0 0 -3");
    run marked = gnomon("transform setup.txt");
    expect_good(&marked);
    assert_string_equal(plain.out, marked.out);
    write_text("setup.txt", "\xef\xbb\xbf\xef\xbb\xbf" GOOD "point 0 0 -3");
    expect(2, "transform setup.txt", "setup.txt:1: ", "convention' is not a statement");
    write_text("setup.txt", "zo\033[31mom\xff\n");
    expect(2, "transform setup.txt", "setup.txt:1: ", "'zo\\x1b[31mom\\xff' is not a statement");
}

TEST(usage)
{
    run r = gnomon("transform --help");
    assert_int_equal(r.status, 0);
    assert_string_equal(r.error, "");
    static const char words[][16] = {"--matrices", "convention", "far infinite", "reversed",
                                     "right X Y Z"};
    for (int i = 0; i < 5; ++i)
        assert_non_null(strstr(r.out, words[i]));
    for (char *line = strtok(r.out, "\n"); line != NULL; line = strtok(NULL, "\n"))
        assert_true(strlen(line) <= 90);
    r = gnomon("transform a b");
    assert_int_equal(r.status, 2);
    assert_non_null(strstr(r.error, "only one setup"));
    r = gnomon("transform nowhere.txt");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, "nowhere.txt: No such file"));
    r = gnomon("transform .");
    assert_int_equal(r.status, 1);
    assert_non_null(strstr(r.error, ".: cannot be read: Is a directory"));
    write_text("setup.txt", GOOD "point 0 0 -3\n");
    r = gnomon("transform setup.txt");
    expect_good(&r);
    write_text("bad.txt", "zoom\n");
    r = gnomon("transform bad.txt");
    assert_int_equal(r.status, 2);
    assert_non_null(strstr(r.error, "bad.txt:1: "));
    r = shell("\"$GNOMON\" transform setup.txt >/dev/full");
    assert_int_equal(r.status, 1);
    r = gnomon("--help");
    assert_non_null(strstr(r.out, "gnomon transform"));
}

/* Options are those of getopt_long, as with the other commands. */
TEST(options_are_those_of_the_other_commands)
{
    static const char *const with_matrices[] = {"--matrices setup.txt", "setup.txt --matrices",
                                                "--m setup.txt", "--matrices -- setup.txt"};
    write_text("setup.txt", GOOD "point 0 0 -3\n");
    write_text("--odd", GOOD "point 0 0 -3\n");
    const run plain = gnomon("transform setup.txt"),
              matrices = gnomon("transform --matrices setup.txt");
    for (size_t i = 0; i < COUNT(with_matrices); ++i) {
        run r = gnomon("transform %s", with_matrices[i]);
        expect_good(&r);
        assert_string_equal(r.out, matrices.out);
    }
    run r = gnomon("transform -- --odd");
    expect_good(&r);
    assert_string_equal(r.out, plain.out);
    r = shell("\"$GNOMON\" transform -- - < setup.txt");
    expect_good(&r);
    assert_string_equal(r.out, plain.out);
    const run help = gnomon("transform --help");
    static const char *const for_help[] = {"-h", "--he", "--help --foo", "setup.txt -h -q"};
    for (size_t i = 0; i < COUNT(for_help); ++i) {
        r = gnomon("transform %s", for_help[i]);
        expect_good(&r);
        assert_string_equal(r.out, help.out);
    }
    expect(2, "transform --nonsense", "unknown option '--nonsense'", "transform --help");
    expect(2, "transform --foo --help", "unknown option '--foo'", "transform --help");
    expect(2, "transform setup.txt -q", "unknown option '-q'", "transform --help");
    expect(2, "transform -m", "unknown option '-m'", "transform --help");
    expect(2, "transform -qh", "unknown option '-qh'", "transform --help");
    expect(2, "transform --help=3", "no value allowed in '--help=3'", "transform --help");
    expect(2, "transform setup.txt -- bad.txt", "'bad.txt'", "only one setup");
    expect(2, "transform setup.txt --matrices -", "'-'", "only one setup");
    expect(2, "transform ''", "''", "an empty file name");
    expect(2, "transform -- ''", "''", "an empty file name");
}
