/* gnomon transform: setups that are refused, with their lines, and its command line. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <string.h>

#define GOOD "convention opengl\nscreen 9 9\nperspective 90\nnear 1\nfar 9\n"

static void expect_error(const char *text, const char *message)
{
    write_text("setup.txt", text);
    expect(2, "transform setup.txt", "gnomon: setup.txt%s", message);
}

/* Setups, and what follows the file's name. */
static const struct {
    const char *text, *message;
} wrong[] = {
    {"\n# nothing\n  zoom 3 # x\n", ":3: 'zoom' is not a statement"},
    {GOOD "point 1 2\n", ":6: point takes 3 numbers, not 2"},
    {GOOD "point 1 2 3 4\n", ":6: point takes 3 numbers, not 4"},
    {GOOD "point 1 x 3\n", ":6: point: 'x' is not a number"},
    {GOOD "point 1 2e 3\n", ":6: point: '2e' is not a number"},
    {GOOD "point 1 1e39 3\n", ":6: point: '1e39' is not a finite 32-bit number"},
    {GOOD "point 1 nan 3\n", ":6: point: 'nan'"},
    {GOOD "point 1 2 3 4 5 6 7 8 9\n", ":6: point: too many words"},
    {GOOD "scale 1 2\n", ":6: scale takes 1 or 3 numbers, not 2"},
    {GOOD "scale 1 0 1\npoint 1 2 3\n", ":6: scale: a factor is zero"},
    {GOOD "point 1 2 3\nrotate 0 0 0 90\n", ":7: rotate: the direction has no length\n"},
    {GOOD "near 2\n", ":6: near is already in line 4"},
    {GOOD "frustum -1 1 -1 1\n", ":6: frustum: line 3 already has perspective"},
    {"convention gl\n", ":1: convention is opengl, direct3d or vulkan"},
    {"depth\n", ":1: depth is plain or reversed"},
    {"far away\n", ":1: far: 'away' is not a number"},
    {"", ": no convention"},
    {"convention opengl\n", ": no screen"},
    {"convention opengl\nscreen 9 9\nnear 1\nfar 9\n", ": no perspective, orthographic or frustum"},
    {"convention opengl\nscreen 9 9\nnear 1\nfar infinite\northographic -1 1 -1 1\n",
     ":4: far: orthographic cannot be infinite"},
    {"convention opengl\nscreen 9 0.5\nperspective 90\nnear 1\nfar 2\n",
     ":2: screen: width and height are 1 to 16384"},
    {GOOD, ": no point"},
    {GOOD "point 1 2 3\nup 0 1 0\nright 1 0 0\n",
     ":8: the camera's axes are right, up and forward; forward is missing\n"},
    {GOOD "point 1 2 3\nright 1 0 0\n",
     ":7: the camera's axes are right, up and forward; up and forward are missing\n"},
    {GOOD "point 1 2 3\nforward 1 0 0\n",
     ":7: the camera's axes are right, up and forward; right and up are missing\n"},
    {GOOD "point 1 2 3\nforward 1 0 0\nright 1 0 0\n",
     ":8: the camera's axes are right, up and forward; up is missing\n"},
    {GOOD "point 1 2 3\nforward 1 0 0\ntarget 1 1 1\n", ":8: target, but line 7"},
    {GOOD "point 1 2 3\nright 1 0 0\nup 1 1 0\nforward 0 0 -1\n",
     ":9: right, up and forward are not perpendicular"},
    {GOOD "point 1 2 3\nright 1 0 0\nup 0 1 0\nforward 0 0 1\n",
     ":9: forward is opposite to what right and up make in a right-handed"},
    {GOOD "point 1 2 3\nright 1 0 0\nup 0 0 0\nforward 0 0 1\n",
     ":8: up: the direction has no length\n"},
    {GOOD "scale 1e30\npoint 0 0 0\npoint 1e30 0 0\n", ":8: point: its coordinates overflow"},
    /* Views that do not exist. */
    {GOOD "point 1 2 3\nposition 1 1 1\ntarget 1 1 1\n",
     ":8: target: it is where the camera is, in line 7\n"},
    {GOOD "point 1 2 3\ntarget 0 -0 0\n", ":7: target: it is where the camera is, at 0 0 0\n"},
    {GOOD "point 1 2 3\nup 0 0 0\ntarget 1 1 1\n", ":7: up: the direction has no length\n"},
    {GOOD "point 1 2 3\nup 0 0 0\n", ":7: up: the direction has no length\n"},
    {GOOD "point 1 2 3\ntarget 0 9 0\n",
     ":7: target: the view is parallel to up, which is 0 1 0 by default\n"},
    {GOOD "point 1 2 3\nup 2 2 2\ntarget -3 -3 -3\n",
     ":8: target: the view is parallel to up, in line 7\n"},
    {GOOD "point 1 2 3\nup 0 0 1\n", ":7: up: it is parallel to the view, which is along z\n"},
    {GOOD "point 1 2 3\nposition 3e38 0 0\ntarget -3e38 0 0\n",
     ":8: target: a number is out of range\n"},
};

TEST(errors_name_the_line)
{
    static char text[2048];
    for (size_t i = 0; i < COUNT(wrong); ++i)
        expect_error(wrong[i].text, wrong[i].message);
    memset(text, ' ', sizeof text);
    strcpy(text + 1500, "\n");
    expect_error(text, ":1: a line of more than");
    expect_shell(2, "echo zoom | gnomon transform", "gnomon: standard input:1: 'zoom' is not");
    expect_shell(2, "gnomon transform <&-", "gnomon: standard input: ");
}

/* A projection with these planes, in lines 4 and 5. */
static void expect_planes(const char *projection, const char *planes, const char *message)
{
    char text[256];
    snprintf(text, sizeof text, "convention opengl\nscreen 9 9\n%s\n%s\npoint 1 2 3\n", projection,
             planes);
    expect_error(text, message);
}

TEST(projections_that_do_not_exist)
{
    static const char *const projections[] = {"orthographic -1 1 -1 1", "perspective 90",
                                              "frustum -1 1 -1 1"};
    for (int i = 0; i < 3; ++i) {
        const char *const p = projections[i];
        expect_planes(p, "near 9\nfar 9", ":5: far: it is not beyond near, which is in line 4\n");
        expect_planes(p, "far 1\nnear 5", ":4: far: it is not beyond near, which is in line 5\n");
        expect_planes(p, "near 1e-44\nfar 2e-44", ":3: ... too large or too small\n");
        if (i == 0)
            continue;
        expect_planes(p, "near 0\nfar 9", ":4: near: it is not above 0\n");
        expect_planes(p, "near -1\nfar infinite", ":4: near: it is not above 0\n");
        expect_planes(p, "near 1\nfar -9", ":5: far: it is not above 0\n");
    }
    expect_planes("perspective 180", "near 1\nfar 9", ":3: ... angle");
    expect_planes("perspective 0", "near 0\nfar 9", ":3: ... angle");
    expect_planes("frustum 2 2 -1 1", "near 1\nfar 9", ":3: frustum: left and right are the same");
    expect_planes("frustum -1 1 0 0", "near 1\nfar infinite",
                  ":3: frustum: bottom and top are the same");
    expect_planes("orthographic 0 0 -1 1", "near 1\nfar 9",
                  ":3: orthographic: left and right are the same");
}

/* A file that is not a text is refused, whatever the lengths of its lines. A byte-order mark is not
 * part of the text. */
TEST(bytes_of_other_kinds)
{
    static char text[4096];
    for (size_t length = 900; length < 2200; length += 13) {
        const int start = snprintf(text, sizeof text,
                                   GOOD "# %0*d\nrotate 0 0 1 90\npoint 1 0 -3\n", (int)length, 0);
        text[strlen(GOOD) + 2] = '\0';
        write_bytes("nul.txt", text, (size_t)start);
        expect(2, "transform nul.txt", "nul.txt:6: a NUL byte");
    }
    write_bytes("nul.txt", GOOD "point 0 0 -3\n\0point 1 0 -3\n", strlen(GOOD) + 27);
    expect(2, "transform nul.txt", "nul.txt:7: a NUL byte");
    expect(2, "transform /dev/zero", "/dev/zero:1: a NUL byte");

    write_text("setup.txt", GOOD "point 0 0 -3\n");
    const run plain = good("transform setup.txt");
    write_text("setup.txt", "\xef\xbb\xbf" GOOD "point 0 0 -3");
    const run marked = good("transform setup.txt");
    assert_string_equal(plain.out, marked.out);
    expect_error("\xef\xbb\xbf\xef\xbb\xbf" GOOD "point 0 0 -3",
                 ":1: ... convention' is not a statement");
    expect_error("zo\033[31mom\xff\n", ":1: 'zo\\x1b[31mom\\xff' is not a statement");
}

/* Options are those of getopt_long, as with the other commands. */
TEST(command_lines)
{
    static const char *const with_matrices[] = {"--matrices setup.txt", "setup.txt --matrices",
                                                "--m setup.txt", "--matrices -- setup.txt"};
    static const char *const without[] = {"-- --odd", "-- - < setup.txt", "< setup.txt"};
    static const char *const for_help[] = {"-h", "--he", "--help --foo", "setup.txt -h -q"};
    static const refusal usage[] = {
        {"--nonsense", "unknown option '--nonsense' (see gnomon transform --help)"},
        {"--foo --help", "unknown option '--foo' (see"},
        {"setup.txt -q", "unknown option '-q' (see"},
        {"-m", "unknown option '-m' (see"},
        {"-qh", "unknown option '-qh' (see"},
        {"--help=3", "no value allowed in '--help=3' (see"},
        {"nul.txt nul.txt", "'nul.txt': only one setup"},
        {"setup.txt --matrices -", "'-': only one setup"},
        {"''", "'': an empty file name"},
        {"-- ''", "'': an empty file name"},
    };
    write_text("setup.txt", GOOD "point 0 0 -3\n");
    write_text("--odd", GOOD "point 0 0 -3\n");
    const run plain = good("transform setup.txt"), help = good("transform --help"),
              matrices = good("transform --matrices setup.txt");
    assert_string_not_equal(plain.out, matrices.out);
    for (size_t i = 0; i < COUNT(with_matrices); ++i)
        assert_string_equal(good("transform %s", with_matrices[i]).out, matrices.out);
    for (size_t i = 0; i < COUNT(without); ++i)
        assert_string_equal(good("transform %s", without[i]).out, plain.out);
    for (size_t i = 0; i < COUNT(for_help); ++i)
        assert_string_equal(good("transform %s", for_help[i]).out, help.out);
    EXPECT_EACH(2, "transform", usage);
    expect(1, "transform nowhere.txt", "nowhere.txt: No such file");
    expect(1, "transform .", ".: cannot be read: Is a directory");
    expect_shell(1, "gnomon transform setup.txt >/dev/full", "");
}
