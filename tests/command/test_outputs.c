/* Where pictures go: names that are refused before anything is drawn, and standard output. */
#define _POSIX_C_SOURCE 200809L
#include "runner.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The name is refused before anything is printed about the picture and before the model is read. */
TEST(names_are_checked_first)
{
    static const struct {
        const char *before, *suffixes;
    } commands[] = {{"render nothing.obj -o", ".png, .tga, .ppm or .raw"},
                    {"render nothing.obj -o b.png --depth", ".png"},
                    {"compare nothing.obj -o", ".png, .tga or .ppm"},
                    {"demo -o", ".png, .tga or .ppm"},
                    {"demo --picture", ".png, .tga or .ppm"}};
    static const refusal names[] = {
        {"nodir/x.png", "nodir/x.png: cannot be written: No such file"},
        {"folder.png", "folder.png: cannot be written: ... directory"},
        {"folder.png/x.png/y.png", "folder.png/x.png/y.png: cannot be written: No such file"}};
    static const char others[][8] = {"a.bmp", "a.jpg", "a.PNG.gz", "a."};
    good_shell("mkdir folder.png");
    for (size_t i = 0; i < COUNT(commands); ++i) {
        EXPECT_EACH(1, commands[i].before, names);
        for (size_t k = 0; k < COUNT(others); ++k) {
            char line[64];
            snprintf(line, sizeof line, "%s %s", commands[i].before, others[k]);
            expect(1, line, "%s: ... must end in %s\n", others[k], commands[i].suffixes);
        }
    }
    expect(1, "render square.obj -o a.png --depth d.tga", "d.tga ... name must end in .png");
    expect(1, "render square.obj -o a.gif", "a.gif: ... 256 colours ... ffmpeg -i FILE.png");
    expect(1, "spin square.obj -o a.GIF", "a.GIF: ... 256 colours ... ffmpeg -i FILE.png");
    expect(1, "demo -o a.raw", "a.raw ... must end in .png, .tga or .ppm");
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

/* All formats have the PNG's pixels; the bytes of TGA and PPM are read here. */
TEST(suffixes_choose_formats)
{
    enum { WIDTH = 300, HEIGHT = 5, PIXELS = WIDTH * HEIGHT };
    static const char ppm_header[] = "P6\n300 5\n255\n";
    static uint8_t bytes[8 * PIXELS];
    const uint8_t tga_header[18] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 44, 1, 5, 0, 32, 0x28};
    run r = good_shell("for o in f.png f.TGA f.ppm; do gnomon render square.obj -o $o --size 300x5 "
                       "--shader normals --rotate 1,2,3,40 --background 12345678 || exit; done");
    expect_printed(&r, "f.ppm: 300x5");
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

    good_shell("set -e; gnomon compare square.obj --size 100x5 -o c.tga; gnomon compare "
               "square.obj --size 100x5 -o c.png");
    p = picture_read("c.png");
    assert_int_equal(read_file("c.tga", bytes, sizeof bytes), 18 + 3 * PIXELS + 26);
    expect_pixels(bytes + 18, &p, 3, true);
    picture_free(&p);

    good_shell("set -e; for f in png tga ppm; do gnomon render square.obj -o - --format $f "
               "--size 8x8 >s.$f; gnomon render square.obj -o t.$f --size 8x8; cmp s.$f t.$f; "
               "done; gnomon render square.obj -o plain --format ppm --size 8x8; cmp plain t.ppm");
    good_shell("mkdir a.b; for o in a.PNG plain .hidden a.b/c; do gnomon render square.obj -o $o "
               "--size 8x8 && head -c 4 $o | grep -q PNG || exit 9; done");
    good_shell("gnomon render square.obj -o a.raw --size 8x6 --background 01020304 && test $(wc -c "
               "<a.raw) = 192 && head -c 4 a.raw | od -An -tx1 | grep -q '01 02 03 04'");
    expect(1, "render square.obj -o /dev/full --format tga --size 8x8", "/dev/full ... No space");
    expect(1, "render square.obj -o /dev/full --format ppm", "/dev/full ... No space");
}

/* Material files and maps that the model or the material names, or that are found by their names,
 * are inputs as the files of options are. */
TEST(files_that_were_read_are_not_replaced)
{
    static const refusal inputs[] = {
        {"render head.obj -o head_diffuse.tga", "head_diffuse.tga"},
        {"render head.obj -o link.tga", "head_diffuse.tga"},
        {"render head.obj --depth head_glow.png -o a.png", "head_glow.png"},
        {"render head.obj -o head_diffuse.tga --sort last", "head_diffuse.tga"},
        {"render square.obj named.obj -o map_2.ppm", "map_2.ppm"},
        {"render named.obj -o map_%d.ppm --views views.txt", "map_2.ppm"},
        {"spin named.obj --frames 3 -o map_%d.ppm", "map_2.ppm"},
        {"spin head.obj -o head_glow.png", "head_glow.png"},
        {"compare named.obj -o map_2.ppm", "map_2.ppm"},
        {"compare named.obj", "named_compared.png"},
    };
    write_text("head.obj", square_obj);
    write_square("named.obj", "mtllib m.mtl\nusemtl a\n");
    write_text("m.mtl", "newmtl a\nmap_Kd map_2.ppm\nmap_Ke named_compared.png\n");
    write_text("views.txt", "--eye 1,2,3\n--eye 2,2,3\n--eye 3,2,3\n");
    good_shell("set -e; for o in head_diffuse.tga head_glow.png map_2.ppm named_compared.png; do "
               "gnomon render square.obj --size 8x8 -o $o; done; ln -sf head_diffuse.tga link.tga; "
               "cp head_diffuse.tga kept; mkdir apart");
    for (size_t i = 0; i < COUNT(inputs); ++i)
        expect(1, inputs[i].arguments, "%s: ... would be overwritten", inputs[i].message);
    expect_same_files("kept", "head_diffuse.tga");

    /* What is not read may be replaced. */
    good("render head.obj --texture none -o head_diffuse.tga --size 8x8");
    good("render named.obj -o apart/map_2.ppm --size 8x8");
    good("spin named.obj --frames 2 -o map_%%d.ppm --size 8x8");
}

/* Only the picture, however standard output is named; messages are on standard error. */
TEST(standard_output_is_the_picture)
{
    static const char *const places[] = {"-o - >s.png",
                                         "-o - | cat >s.png",
                                         "-o /dev/stdout >s.png",
                                         "-o /dev/stdout | cat >s.png",
                                         "-o /dev/fd/1 | cat >s.png",
                                         "-o s.png >s.png"};
    run r = good("render square.obj --size 16x16 -o file.png");
    assert_string_equal(r.error, "");
    expect_printed(&r, "file.png: 16x16, 2 triangles");
    for (size_t i = 0; i < COUNT(places); ++i) {
        remove_file("s.png");
        r = good_shell("set -e; gnomon render square.obj --size 16x16 %s; cmp s.png file.png",
                       places[i]);
        if (strstr(r.error, ": 16x16, 2 triangles") == NULL || lines(r.error) != 1)
            fail_run(&r);
    }
    r = good_shell("gnomon compare square.obj --size 16x16 -o c.png && gnomon compare "
                   "square.obj --size 16x16 -o - >s.png && cmp s.png c.png");
    expect_printed(&r, "colour: 0 of 256");
    assert_non_null(strstr(r.error, "colour: 0 of 256"));
    assert_non_null(strstr(r.error, "\n-: Gnomon, OSMesa, difference\n"));
    r = good_shell("gnomon demo --size 32x24 --picture p.png -o c.png && gnomon demo --size "
                   "32x24 --picture /dev/stdout -o c2.png | cmp - p.png && cmp c.png c2.png");
    assert_non_null(strstr(r.error, "depth:  0 of 768"));
    /* Only the depth. */
    good_shell("gnomon render square.obj --size 16x16 -o d.png --depth e.png && gnomon render "
               "square.obj --size 16x16 -o d.png --depth - | cmp - e.png");
    expect(1, "render square.obj -o - --depth /dev/stdout", "- ... both");
    expect(1, "demo -o /dev/stdout --picture -", "/dev/stdout ... both");
    expect_shell(1, "gnomon render square.obj --size 16x16 -o - >/dev/full",
                 "gnomon: -: cannot be written: No space");
    assert_false(exists("-"));
}

/* Files that the command opens later must not take their numbers. */
TEST(standard_files_may_be_closed)
{
    good("render square.obj -o open.png --size 16x16");
    good_shell("gnomon render square.obj -o closed.png --size 16x16 <&- 2>&- && "
               "cmp open.png closed.png");
    expect_shell(1, "gnomon render square.obj -o shut.png --size 16x16 <&- >&-",
                 "gnomon: standard output: cannot be written");
    expect_same_files("open.png", "shut.png");
    expect_shell(1, "gnomon render nothing.obj -o none.png 2>&-", "");
    assert_false(exists("none.png"));
}

/* What could not be written is named with the first reason, whatever fails after it. */
TEST(lost_output_keeps_its_reason)
{
    static const struct {
        const char *line, *error;
    } cases[] = {
        {"info square.obj >&-", "gnomon: standard output: cannot be written: Bad file descriptor"},
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
    for (size_t i = 0; i < COUNT(cases); ++i) {
        run r = shell("gnomon %s", cases[i].line);
        const size_t length = strlen(cases[i].error);
        if (r.status != 1 || strncmp(r.error, cases[i].error, length) != 0 ||
            strcmp(r.error + length, "\n") != 0)
            fail_run(&r);
    }
}

/* A picture is made where a link leads, and the link stays. */
TEST(links_are_followed)
{
    good_shell(
        "set -e; mkdir real links; ln -s real/x.png here.png; ln -s ../real/y.png links/y.png; "
        "ln -s \"$PWD/real/z.png\" z.png; ln -s links/y.png chain.png; ln -s real/deep.png "
        "deep.png; "
        "ln -s /nonexistent/dir/x.png lost.png; ln -s loop.png loop.png; "
        "for o in here.png chain.png z.png; do gnomon render square.obj --size 8x8 -o $o; "
        "test -L $o; done; test -L links/y.png; for f in x y z; do test -f real/$f.png; "
        "test ! -L real/$f.png; done; test $(ls real links | wc -l) = 7; rm real/*; "
        "gnomon spin square.obj --size 8x8 --frames 2 -o z.png; test -L z.png; "
        "test -f real/z.png");
    static const refusal lost[] = {
        {"square.obj -o lost.png", "lost.png: cannot be written: No such file"},
        {"nothing.obj -o lost.png", "lost.png: cannot be written: No such file"},
        {"nothing.obj -o loop.png", "loop.png: cannot be written: Too many levels"},
        {"square.obj -o deep.png --depth real/deep.png", "deep.png: cannot be both"},
        {"square.obj -o real/deep.png --depth deep.png", "deep.png: cannot be both"},
    };
    EXPECT_EACH(1, "render", lost);
    good_shell("test -L lost.png && test -L loop.png && test -L deep.png && test ! -e deep.png");
}

/* Runs a line of shell without the right to write everywhere, which root has. */
static run without_rights(const char *line)
{
    return shell("%s sh -c '%s'",
                 geteuid() == 0
                     ? "setpriv --inh-caps=-all --bounding-set=-dac_override,-dac_read_search"
                     : "",
                 line);
}

/* The directory is named if it, and not the file, is the obstacle. */
TEST(directories_are_named)
{
    static const char made[] = "no file can be made in the directory ";
    static const struct {
        const char *line, *path, *made, *directory;
    } cases[] = {{"gnomon render square.obj -o", "closed/rw.png", made, "'closed/': "},
                 {"gnomon render square.obj -o", "closed/none.png", made, "'closed/': "},
                 {"gnomon render square.obj -o", "./closed/rw.png", made, "'./closed/': "},
                 {"gnomon render square.obj -o", "to.png", made, "'closed/': "},
                 {"cd closed; gnomon render ../square.obj -o", "rw.png", made, "'.': "},
                 /* The file is the obstacle. */
                 {"gnomon render square.obj -o", "closed/r.png", "", ""}};
    char line[128], expected[256];
    run r = without_rights("mkdir closed && touch closed/rw.png closed/r.png && "
                           "ln -s ../outside.png closed/link.png && chmod 400 closed/r.png && "
                           "ln -s closed/none.png to.png && chmod 500 closed && "
                           "! touch closed/probe 2>error");
    if (r.status != 0) {
        print_message("skipped: directories without rights: setpriv is absent or cannot drop "
                      "them\n");
        return;
    }
    for (size_t i = 0; i < COUNT(cases); ++i) {
        snprintf(line, sizeof line, "%s %s --size 8x8", cases[i].line, cases[i].path);
        r = without_rights(line);
        assert_int_equal(r.status, 1);
        snprintf(expected, sizeof expected,
                 "gnomon: %s: cannot be written: %s%sPermission denied\n", cases[i].path,
                 cases[i].made, cases[i].directory);
        assert_string_equal(r.error, expected);
    }
    r = without_rights("gnomon render square.obj -o closed/link.png --size 8x8");
    assert_int_equal(r.status, 0);
    assert_true(exists("outside.png"));
}

/* A name may have all the 255 bytes that a file system allows. */
TEST(names_may_be_long)
{
    char name[300], line[512];
    for (int length = 245; length <= 255; ++length) {
        snprintf(name, sizeof name, "%0*d.png", length - 4, 0);
        runner_mark();
        good("render square.obj --size 8x8 -o %s", name);
        assert_true(exists(name));
        remove_file(name);
        assert_int_equal(new_files(), 0);
    }
    /* Characters of two bytes: a cut name is UTF-8 too. */
    good_shell("n=$(printf '%%0125d' 0 | sed 's/0/\xc3\xa4/g').png; gnomon render "
               "square.obj --size 8x8 -o $n && test -f $n && rm $n");
    snprintf(name, sizeof name, "%0252d.png", 0);
    snprintf(line, sizeof line, "render nothing.obj -o %s", name);
    expect(1, line, "%s ... cannot be written: File name too long", name);
}
