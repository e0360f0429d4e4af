/* Where pictures go: names that are refused before anything is drawn, and standard output. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

TEST(other_extensions_are_refused)
{
    static const char names[][8] = {"a.bmp", "a.jpg", "a.PNG.gz", "a."};
    char line[1024];
    write_text("square.obj", square_obj);
    for (int i = 0; i < 4; ++i) {
        snprintf(line, sizeof line, "render square.obj -o %s", names[i]);
        expect(1, line, names[i], "must end in .png, .tga, .ppm or .raw");
        snprintf(line, sizeof line, "render square.obj -o a.png --depth %s", names[i]);
        expect(1, line, names[i], "name must end in .png");
        snprintf(line, sizeof line, "compare square.obj -o %s", names[i]);
        expect(1, line, names[i], "must end in .png, .tga or .ppm");
        snprintf(line, sizeof line, "demo -o %s", names[i]);
        expect(1, line, names[i], "must end in .png, .tga or .ppm");
        snprintf(line, sizeof line, "demo --picture %s", names[i]);
        expect(1, line, names[i], "must end in .png, .tga or .ppm");
    }
    expect(1, "render square.obj -o a.png --depth d.tga", "d.tga", "name must end in .png");
    expect(1, "demo -o a.raw", "a.raw", "must end in .png, .tga or .ppm");
    run r =
        shell("mkdir a.b; for o in a.PNG plain .hidden a.b/c; do \"$GNOMON\" render square.obj -o "
              "$o --size 8x8 && head -c 4 $o | grep -q PNG || exit 9; done");
    assert_int_equal(r.status, 0);
    r = shell(
        "\"$GNOMON\" render square.obj -o a.raw --size 8x6 --background 01020304 && "
        "test $(wc -c <a.raw) = 192 && head -c 4 a.raw | od -An -tx1 | grep -q '01 02 03 04'");
    assert_int_equal(r.status, 0);
}

/* A picture's bytes after its header, with alpha or without. */
static void expect_pixels(const uint8_t *bytes, const picture *p, size_t channels, bool blue_first)
{
    for (size_t i = 0; i < (size_t)p->width * p->height; ++i) {
        const uint8_t *pixel = bytes + channels * i;
        const uint8_t *expected = p->rgba + 4 * i;
        assert_int_equal(pixel[0], expected[blue_first ? 2 : 0]);
        assert_int_equal(pixel[1], expected[1]);
        assert_int_equal(pixel[2], expected[blue_first ? 0 : 2]);
        if (channels == 4)
            assert_int_equal(pixel[3], expected[3]);
    }
}

static size_t read_file(const char *name, uint8_t *bytes, size_t size)
{
    FILE *file = fopen(path_of(name), "rb");
    assert_non_null(file);
    const size_t length = fread(bytes, 1, size, file);
    fclose(file);
    return length;
}

/* All formats have the PNG's pixels; the bytes of TGA and PPM are read here. */
TEST(suffixes_choose_formats)
{
    enum { WIDTH = 300, HEIGHT = 5, PIXELS = WIDTH * HEIGHT };
    static const char ppm_header[] = "P6\n300 5\n255\n";
    static uint8_t bytes[8 * PIXELS];
    const uint8_t tga_header[18] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 44, 1, 5, 0, 32, 0x28};
    write_text("square.obj", square_obj);
    run r = shell("for o in f.png f.TGA f.ppm; do \"$GNOMON\" render square.obj -o $o --size 300x5 "
                  "--shader normals --rotate 1,2,3,40 --background 12345678 || exit; done");
    assert_int_equal(r.status, 0);
    assert_non_null(strstr(r.out, "f.ppm: 300x5"));
    picture p = picture_read("f.png");
    assert_int_equal(pixel(&p, 0, 0), 0x12345678);
    assert_int_equal(read_file("f.TGA", bytes, sizeof bytes), 18 + 4 * PIXELS + 26);
    assert_memory_equal(bytes, tga_header, sizeof tga_header);
    expect_pixels(bytes + 18, &p, 4, true);
    assert_memory_equal(bytes + 18 + 4 * PIXELS + 8, "TRUEVISION-XFILE.", 18);
    assert_int_equal(read_file("f.ppm", bytes, sizeof bytes), sizeof ppm_header - 1 + 3 * PIXELS);
    assert_memory_equal(bytes, ppm_header, sizeof ppm_header - 1);
    expect_pixels(bytes + sizeof ppm_header - 1, &p, 3, false);
    picture_free(&p);

    r = shell("set -e; \"$GNOMON\" compare square.obj --size 100x5 -o c.tga; \"$GNOMON\" compare "
              "square.obj --size 100x5 -o c.png");
    assert_int_equal(r.status, 0);
    p = picture_read("c.png");
    assert_int_equal(read_file("c.tga", bytes, sizeof bytes), 18 + 3 * PIXELS + 26);
    expect_pixels(bytes + 18, &p, 3, true);
    picture_free(&p);

    r = shell(
        "set -e; for f in png tga ppm; do \"$GNOMON\" render square.obj -o - --format $f "
        "--size 8x8 >s.$f; \"$GNOMON\" render square.obj -o t.$f --size 8x8; cmp s.$f t.$f; "
        "done; \"$GNOMON\" render square.obj -o plain --format ppm --size 8x8; cmp plain t.ppm");
    assert_int_equal(r.status, 0);
    expect(1, "render square.obj -o /dev/full --format tga --size 8x8", "/dev/full", "No space");
    expect(1, "render square.obj -o /dev/full --format ppm", "/dev/full", "No space");
}

/* The name is refused before anything is printed about the picture and before the model is read. */
TEST(names_are_checked_first)
{
    static const char commands[][40] = {"render nothing.obj -o",
                                        "render nothing.obj -o b.png --depth",
                                        "compare nothing.obj -o", "demo -o", "demo --picture"};
    char line[1024];
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

/* Material files and maps that the model or the material names, or that are found by their names,
 * are inputs as the files of options are. */
TEST(files_that_were_read_are_not_replaced)
{
    static const char words[] = "would be overwritten";
    char model[1024];
    snprintf(model, sizeof model, "mtllib m.mtl\nusemtl a\n%s", square_obj);
    write_text("square.obj", square_obj);
    write_text("head.obj", square_obj);
    write_text("named.obj", model);
    write_text("m.mtl", "newmtl a\nmap_Kd map_2.ppm\n");
    write_text("views.txt", "--eye 1,2,3\n--eye 2,2,3\n--eye 3,2,3\n");
    run r =
        shell("set -e; for o in head_diffuse.tga head_glow.png map_2.ppm; do \"$GNOMON\" render "
              "square.obj --size 8x8 -o $o; done; ln -sf head_diffuse.tga link.tga; "
              "cp head_diffuse.tga kept; mkdir apart");
    assert_int_equal(r.status, 0);
    expect(1, "render head.obj -o head_diffuse.tga", "head_diffuse.tga", words);
    expect(1, "render head.obj -o link.tga", "head_diffuse.tga", words);
    expect(1, "render head.obj --depth head_glow.png -o a.png", "head_glow.png", words);
    expect(1, "render head.obj -o head_diffuse.tga --sort last", "head_diffuse.tga", words);
    expect(1, "render square.obj named.obj -o map_2.ppm", "map_2.ppm", words);
    expect(1, "render named.obj -o map_%d.ppm --views views.txt", "map_2.ppm", words);
    expect(1, "spin named.obj --frames 3 -o map_%d.ppm", "map_2.ppm", words);
    expect(1, "spin head.obj -o head_glow.png", "head_glow.png", words);
    expect(1, "compare named.obj -o map_2.ppm", "map_2.ppm", words);
    r = shell("cmp kept head_diffuse.tga && cp head_glow.png named_compared.png && "
              "echo map_Ke named_compared.png >>m.mtl");
    assert_int_equal(r.status, 0);
    expect(1, "compare named.obj", "named_compared.png", words);

    /* What is not read may be replaced. */
    r = gnomon("render head.obj --texture none -o head_diffuse.tga --size 8x8");
    assert_int_equal(r.status, 0);
    r = gnomon("render named.obj -o apart/map_2.ppm --size 8x8");
    assert_int_equal(r.status, 0);
    r = gnomon("spin named.obj --frames 2 -o map_%%d.ppm --size 8x8");
    assert_int_equal(r.status, 0);
}

/* Only the picture, however standard output is named; messages are on standard error. */
TEST(standard_output_is_the_picture)
{
    static const char lines_of_shell[][96] = {
        "\"$GNOMON\" render square.obj --size 16x16 -o - >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o - | cat >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o /dev/stdout >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o /dev/stdout | cat >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o /dev/fd/1 | cat >s.png",
        "\"$GNOMON\" render square.obj --size 16x16 -o s.png >s.png"};
    write_text("square.obj", square_obj);
    run r = gnomon("render square.obj --size 16x16 -o file.png");
    assert_string_equal(r.error, "");
    assert_non_null(strstr(r.out, "file.png: 16x16, 2 triangles"));
    for (size_t i = 0; i < COUNT(lines_of_shell); ++i) {
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
TEST(standard_files_may_be_closed)
{
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

/* What could not be written is named with the first reason, whatever fails after it. */
TEST(lost_output_keeps_its_reason)
{
    static const struct {
        const char *line, *error;
    } cases[] = {
        {"info square.obj >&-", "gnomon: standard output: cannot be written: Bad file descriptor"},
        {"info square.obj nope >&-",
         "gnomon: nope: cannot be read as a picture: No such file or directory\n"
         "gnomon: standard output: cannot be written: Bad file descriptor"},
        {"info square.obj nope >/dev/full",
         "gnomon: nope: cannot be read as a picture: No such file or directory\n"
         "gnomon: standard output: cannot be written: No space left on device"},
        {"--help >&-", "gnomon: standard output: cannot be written: Bad file descriptor"},
        {"render square.obj -o - >&-", "gnomon: -: cannot be written: Bad file descriptor"},
        {"render square.obj -o /dev/stdout >&-",
         "gnomon: /dev/stdout: cannot be written: Bad file descriptor"},
        {"render square.obj -o - --format ppm 1</dev/null",
         "gnomon: -: cannot be written: Bad file descriptor"},
    };
    char line[256], error[256];
    write_text("square.obj", square_obj);
    for (size_t i = 0; i < COUNT(cases); ++i) {
        snprintf(line, sizeof line, "\"$GNOMON\" %s", cases[i].line);
        run r = shell(line);
        snprintf(error, sizeof error, "%s\n", cases[i].error);
        if (r.status != 1 || strcmp(r.error, error) != 0)
            fail_msg("%s: status %d, %s", line, r.status, r.error);
    }
}

/* A picture is made where a link leads, and the link stays. */
TEST(links_are_followed)
{
    write_text("square.obj", square_obj);
    run r = shell(
        "set -e; mkdir real links; ln -s real/x.png here.png; ln -s ../real/y.png links/y.png; "
        "ln -s \"$PWD/real/z.png\" z.png; ln -s links/y.png chain.png; ln -s real/deep.png "
        "deep.png; "
        "ln -s /nonexistent/dir/x.png lost.png; ln -s loop.png loop.png; "
        "for o in here.png chain.png z.png; do \"$GNOMON\" render square.obj --size 8x8 -o $o; "
        "test -L $o; done; test -L links/y.png; for f in x y z; do test -f real/$f.png; "
        "test ! -L real/$f.png; done; test $(ls real links | wc -l) = 7; rm real/*; "
        "\"$GNOMON\" spin square.obj --size 8x8 --frames 2 -o z.png; test -L z.png; "
        "test -f real/z.png");
    if (r.status != 0)
        fail_msg("status %d: %s%s", r.status, r.out, r.error);
    expect(1, "render square.obj -o lost.png", "lost.png: cannot be written: No such file", "");
    expect(1, "render nothing.obj -o lost.png", "lost.png: cannot be written: No such file", "");
    expect(1, "render nothing.obj -o loop.png", "loop.png: cannot be written: Too many levels", "");
    expect(1, "render square.obj -o deep.png --depth real/deep.png", "deep.png", "both");
    expect(1, "render square.obj -o real/deep.png --depth deep.png", "deep.png", "both");
    r = shell("test -L lost.png && test -L loop.png && test -L deep.png && test ! -e deep.png");
    assert_int_equal(r.status, 0);
}

/* Runs a line of shell without the right to write everywhere, which root has. */
static run without_rights(const char *line)
{
    char full[1024];
    snprintf(full, sizeof full, "%s sh -c '%s'",
             geteuid() == 0
                 ? "setpriv --inh-caps=-all --bounding-set=-dac_override,-dac_read_search"
                 : "",
             line);
    return shell(full);
}

/* The directory is named if it, and not the file, is the obstacle. */
TEST(directories_are_named)
{
    static const char no_file[] = "cannot be written: no file can be made in the directory ";
    char expected[256];
    write_text("square.obj", square_obj);
    run r = without_rights("mkdir closed && touch closed/rw.png closed/r.png && "
                           "ln -s ../outside.png closed/link.png && chmod 400 closed/r.png && "
                           "ln -s closed/none.png to.png && chmod 500 closed && "
                           "! touch closed/probe 2>error");
    if (r.status != 0) {
        print_message("skipped: directories without rights: setpriv is absent or cannot drop "
                      "them\n");
        return;
    }
    static const struct {
        const char *path, *directory;
    } cases[] = {{"closed/rw.png", "closed/"},
                 {"closed/none.png", "closed/"},
                 {"./closed/rw.png", "./closed/"},
                 {"to.png", "closed/"}};
    for (size_t i = 0; i < COUNT(cases); ++i) {
        char line[128];
        snprintf(line, sizeof line, "\"$GNOMON\" render square.obj -o %s --size 8x8",
                 cases[i].path);
        r = without_rights(line);
        assert_int_equal(r.status, 1);
        snprintf(expected, sizeof expected, "gnomon: %s: %s'%s': Permission denied\n",
                 cases[i].path, no_file, cases[i].directory);
        assert_string_equal(r.error, expected);
    }
    r = without_rights("cd closed; \"$GNOMON\" render ../square.obj -o rw.png --size 8x8");
    assert_int_equal(r.status, 1);
    snprintf(expected, sizeof expected, "gnomon: rw.png: %s'.': Permission denied\n", no_file);
    assert_string_equal(r.error, expected);
    /* The file is the obstacle; there is none. */
    r = without_rights("\"$GNOMON\" render square.obj -o closed/r.png --size 8x8");
    assert_string_equal(r.error, "gnomon: closed/r.png: cannot be written: Permission denied\n");
    r = without_rights("\"$GNOMON\" render square.obj -o closed/link.png --size 8x8");
    assert_int_equal(r.status, 0);
    assert_true(exists("outside.png"));
}

/* A name may have all the 255 bytes that a file system allows. */
TEST(names_may_be_long)
{
    char name[300], line[512];
    write_text("square.obj", square_obj);
    for (int length = 245; length <= 255; ++length) {
        snprintf(name, sizeof name, "%0*d.png", length - 4, 0);
        runner_mark();
        run r = gnomon("render square.obj --size 8x8 -o %s", name);
        if (r.status != 0)
            fail_msg("%d bytes: %s", length, r.error);
        assert_true(exists(name));
        remove_file(name);
        assert_int_equal(new_files(), 0);
    }
    /* Characters of two bytes: a cut name is UTF-8 too. */
    run r = shell("n=$(printf '%0125d' 0 | sed 's/0/\xc3\xa4/g').png; \"$GNOMON\" render "
                  "square.obj --size 8x8 -o $n && test -f $n && rm $n");
    assert_int_equal(r.status, 0);
    snprintf(name, sizeof name, "%0252d.png", 0);
    snprintf(line, sizeof line, "render nothing.obj -o %s", name);
    expect(1, line, name, "cannot be written: File name too long");
}
