/* Files of views: what a line sets and what it leaves as on the command line; faults name the line
 * and the option. */
#define _POSIX_C_SOURCE 200809L
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "report.h"
#include "views.h"

static char path[64], said[8192];
static int lines;

static void keep(const char *line)
{
    ++lines;
    snprintf(said, sizeof said, "%s", line);
}

static camera_options plain(void)
{
    camera_options c;
    memset(&c, 0, sizeof c);
    c.up.y = 1.0f;
    c.fov_degrees = 40.0f;
    return c;
}

void suite_begin(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    snprintf(path, sizeof path, "/tmp/gnomon-views-%ld", (long)getpid());
}

void suite_end(void)
{
    remove(path);
}

static int read_bytes(const char *text, size_t size, const camera_options *others, views *v)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, size, file), size);
    fclose(file);
    lines = 0;
    said[0] = '\0';
    report_to(keep);
    const int status = views_read(path, others, v);
    report_to(NULL);
    return status;
}

static int read_text(const char *text, const camera_options *others, views *v)
{
    return read_bytes(text, strlen(text), others, v);
}

TEST(lines_set_cameras)
{
    const camera_options others = plain();
    views v;
    assert_int_equal(read_text("# around\n\n--eye 1,2,3 --up=0,0,1\r\n \t\n"
                               "\t--target 4,5,6 --fov 30 --near 1 --far 9#x\n",
                               &others, &v),
                     EXIT_USAGE); /* # begins a comment only where a word begins */
    views_free(&v);
    assert_int_equal(read_text("# around\n\n--eye 1,2,3 --up=0,0,1\r\n \t\n"
                               "\t--target 4,5,6 --fov 30 --near 1 --far 9 #x\n"
                               "--orthographic 2.5",
                               &others, &v),
                     0);
    assert_int_equal(lines, 0);
    assert_int_equal(v.count, 3);
    const camera_options *c = &v.list[0].camera;
    assert_int_equal(v.list[0].line, 3);
    assert_true(c->eye_given && c->up_given && !c->target_given && !c->fov_given);
    assert_true(c->eye.x == 1 && c->eye.y == 2 && c->eye.z == 3);
    assert_true(c->up.x == 0 && c->up.y == 0 && c->up.z == 1);
    c = &v.list[1].camera;
    assert_int_equal(v.list[1].line, 5);
    assert_true(!c->eye_given && c->target_given && c->fov_given && !c->orthographic);
    assert_true(c->target.z == 6 && c->fov_degrees == 30);
    assert_true(c->near_given && c->near == 1 && c->far_given && c->far == 9);
    c = &v.list[2].camera;
    assert_int_equal(v.list[2].line, 6);
    assert_true(c->orthographic && c->orthographic_height == 2.5f && !c->fov_given);
    views_free(&v);
}

/* A line's projection replaces that of the command line. */
TEST(other_options_stay)
{
    camera_options others = plain();
    views v;
    others.eye_given = others.far_given = others.orthographic = true;
    others.eye = (gn_vec3){7, 8, 9};
    others.far = 50;
    others.orthographic_height = 3;
    assert_int_equal(read_text("--up 1,0,0\n--fov 20\n--orthographic 4\n", &others, &v), 0);
    assert_int_equal(v.count, 3);
    for (uint32_t i = 0; i < 3; ++i) {
        const camera_options *c = &v.list[i].camera;
        assert_true(c->eye_given && c->eye.x == 7 && c->eye.z == 9);
        assert_true(c->far_given && c->far == 50 && !c->near_given);
        assert_int_equal(c->orthographic, i != 1);
        assert_int_equal(c->fov_given, i == 1);
        assert_true(c->orthographic_height == (i == 2 ? 4.0f : 3.0f));
    }
    views_free(&v);
    others.orthographic = false;
    others.fov_given = true;
    others.fov_degrees = 70;
    assert_int_equal(read_text("--up 1,0,0\n--orthographic 4\n", &others, &v), 0);
    assert_true(v.list[0].camera.fov_given && v.list[0].camera.fov_degrees == 70);
    assert_true(!v.list[1].camera.fov_given && v.list[1].camera.orthographic);
    views_free(&v);
}

/* A byte-order mark is skipped at the beginning of the file, and only there. */
TEST(a_byte_order_mark_is_skipped)
{
    static const char mark[] = "\xef\xbb\xbf";
    const camera_options others = plain();
    char text[64];
    views v;
    snprintf(text, sizeof text, "%s--fov 30\n--fov 40\n", mark);
    assert_int_equal(read_text(text, &others, &v), 0);
    assert_int_equal(v.count, 2);
    assert_int_equal(v.list[0].line, 1);
    assert_true(v.list[0].camera.fov_degrees == 30);
    views_free(&v);
    snprintf(text, sizeof text, "%s# a comment\n--fov 40\n", mark);
    assert_int_equal(read_text(text, &others, &v), 0);
    assert_int_equal(v.count, 1);
    views_free(&v);
    assert_int_equal(read_text(mark, &others, &v), EXIT_USAGE);
    assert_non_null(strstr(said, "has no view"));
    views_free(&v);
    snprintf(text, sizeof text, "--fov 30\n%s--fov 40\n", mark);
    assert_int_equal(read_text(text, &others, &v), EXIT_USAGE);
    assert_non_null(strstr(said, ":2: "));
    views_free(&v);
}

static void expect_wrong(const char *text, size_t size, const char *first, const char *second)
{
    const camera_options others = plain();
    char place[128];
    views v;
    assert_int_equal(read_bytes(text, size, &others, &v), EXIT_USAGE);
    assert_int_equal(lines, 1);
    snprintf(place, sizeof place, "gnomon: %s%s", path, first);
    if (strstr(said, place) != said || strstr(said, second) == NULL)
        fail_msg("%s: said '%s'", text, said);
    views_free(&v);
}

TEST(faults_name_line_and_option)
{
    static const char zero[] = "--eye 1,2,3\n--fov 4\0 5\n";
    static const struct {
        const char *text, *first, *second;
    } faults[] = {
        {"", ": ", "no view"},
        {"# nothing\n\n", ": ", "no view"},
        {"--fov 40\n--eye 1,2\n", ":2: --eye: ", "'1,2': not three numbers"},
        {"\n--eye", ":2: --eye: ", "no value"},
        {"--up # 0,0,1\n", ":1: --up: ", "no value"},
        {"--up=\n", ":1: --up: ", "'': not three"},
        {"--near x\n", ":1: --near: ", "'x': not a distance"},
        {"--fov 1e99\n", ":1: --fov: ", "finite in 32 bits"},
        {"--eye 1,2,3 --size 4x4\n", ":1: --size: ", "not an option of a camera"},
        {"--nothing=4\n", ":1: --nothing: ", "not an option of a camera"},
        {"--eye 1,2,3 4\n", ":1: 4: ", "not an option of a camera"},
        {"-eye 1,2,3\n", ":1: -eye: ", "not an option of a camera"},
        {"--ey 1,2,3\n", ":1: --ey: ", "not an option of a camera"},
        {"--\n", ":1: --: ", "not an option of a camera"},
        {"--fov 3 --orthographic 4\n", ":1: --fov: ", "together"},
    };
    for (size_t i = 0; i < COUNT(faults); ++i)
        expect_wrong(faults[i].text, strlen(faults[i].text), faults[i].first, faults[i].second);
    expect_wrong(zero, sizeof zero - 1, ":2: view: ", "zero byte");
    const camera_options others = plain();
    views v;
    report_to(keep);
    assert_int_equal(views_read("no/such/file", &others, &v), EXIT_FAULT);
    report_to(NULL);
    assert_non_null(strstr(said, "no/such/file: cannot be read: No such file"));
    views_free(&v);
}

TEST(many_views_have_a_limit)
{
    static const char line[] = "--fov 9\n";
    const size_t length = sizeof line - 1;
    char *text = malloc((VIEWS_MOST + 1) * length);
    const camera_options others = plain();
    views v;
    assert_non_null(text);
    for (size_t i = 0; i <= VIEWS_MOST; ++i)
        memcpy(text + i * length, line, length);
    assert_int_equal(read_bytes(text, VIEWS_MOST * length, &others, &v), 0);
    assert_int_equal(v.count, VIEWS_MOST);
    assert_int_equal(v.list[VIEWS_MOST - 1].line, VIEWS_MOST);
    views_free(&v);
    expect_wrong(text, (VIEWS_MOST + 1) * length, ":100001: view: ", "more than 100000");
    free(text);
}

TEST(impossible_cameras_are_named)
{
    static const struct {
        const char *text, *place;
    } faults[] = {
        {"--fov 30\n\n--eye 1,1,1 --target 1,1,1\n", ":3: --eye: impossible"},
        {"--fov 30\n--up 0,0,0\n", ":2: --up: impossible"},
        {"--fov 180\n", ":1: --fov: impossible"},
        {"--fov 9\n--near 5 --far 4\n", ":2: --far: impossible"},
    };
    const bounding_sphere sphere = {{0, 0, 0}, 1, {0.0, 0.0, 0.0}};
    const camera_options others = plain();
    char expected[128];
    views v;
    for (size_t i = 0; i < COUNT(faults); ++i) {
        assert_int_equal(read_text(faults[i].text, &others, &v), 0);
        report_to(keep);
        assert_int_equal(views_check(path, &v, &sphere, 40, 30), EXIT_FAULT);
        report_to(NULL);
        snprintf(expected, sizeof expected, "gnomon: %s%s", path, faults[i].place);
        if (strstr(said, expected) != said)
            fail_msg("%s: said '%s'", faults[i].text, said);
        views_free(&v);
    }
    assert_int_equal(read_text("--fov 30\n--eye 0,0,9\n", &others, &v), 0);
    assert_int_equal(views_check(path, &v, &sphere, 40, 30), 0);
    views_free(&v);
    /* A place is named for its own faults alone. */
    report_to(keep);
    report_fault("other", "fault");
    report_to(NULL);
    assert_string_equal(said, "gnomon: other: fault");
}
