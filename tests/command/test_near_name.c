/* Names that are near one that does not exist. */
#define _POSIX_C_SOURCE 200809L
#include "suite.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "near_name.h"

static char folder[] = "/tmp/gnomon-near-XXXXXX";

static void touch(const char *name)
{
    FILE *file = fopen(name, "w");
    assert_non_null(file);
    fclose(file);
}

/* Expects the nearest name to be this one; null: none. */
static void expect(const char *path, const char *expected)
{
    char *found = files_nearest(path);
    if (expected == NULL ? found != NULL : found == NULL || strcmp(found, expected) != 0)
        fail_msg("'%s': '%s', expected '%s'", path, found != NULL ? found : "none",
                 expected != NULL ? expected : "none");
    free(found);
}

void suite_begin(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    if (mkdtemp(folder) == NULL || chdir(folder) != 0)
        exit(1);
}

void suite_end(void)
{
    char line[64];
    snprintf(line, sizeof line, "rm -rf %s", folder);
    if (chdir("/") != 0 || system(line) != 0)
        fprintf(stderr, "%s is left behind\n", folder);
}

TEST(spellings_are_equal)
{
    touch("wood.png");
    touch("my map.png");
    expect("Wood.PNG", "wood.png");
    expect("./WOOD.png", "wood.png");
    expect("wood.png ", "wood.png");
    expect("wood.png\r", "wood.png");
    expect("my%20map.png", "my map.png");
    expect("MY%20Map.png", "my map.png");
    expect("wood.png", NULL);
    touch("100%25.png");
    expect("100%.png", "100%25.png");
    expect("100%zz.png", "100%25.png"); /* no code; two characters too many */
    expect("100%zzz.png", NULL);
    expect("%", NULL);
    expect("wood%00.png", NULL);
}

TEST(folders_are_those_of_the_path)
{
    char path[128];
    assert_int_equal(mkdir("maps", 0700), 0);
    touch("maps/stone.tga");
    expect("maps/Stone.tga", "stone.tga");
    expect("maps\\Stone.tga", "stone.tga");
    expect("Stone.tga", NULL);
    expect("nowhere/stone.tga", NULL);
    snprintf(path, sizeof path, "%s/maps/STONE.TGA", folder);
    expect(path, "stone.tga");
    expect("", NULL);
    expect("maps/", NULL);
    expect("nowhere/", NULL);
}

TEST(endings_may_differ)
{
    touch("brick.jpg");
    touch("brick.obj");
    expect("brick.png", "brick.jpg");
    expect("BRICK.tga", "brick.jpg");
    expect("brick.glb", NULL);
    touch("brick.bmp");
    expect("brick.png", "brick.bmp");
}

TEST(two_letters_may_differ)
{
    touch("marble.png");
    expect("marbel.png", "marble.png");  /* two replaced */
    expect("marbles.png", "marble.png"); /* one removed */
    expect("mrble.png", "marble.png");   /* one inserted */
    expect("mable.pn", "marble.png");
    expect("arbl.png", "marble.png");
    expect("marblexxx.png", NULL);
    expect("marblexx.png", "marble.png");
    expect("rbl.png", NULL);
    /* One difference before two; letter case before both. */
    touch("marbles2.png");
    expect("marbles.png", "marble.png");
    expect("marbles1.png", "marbles2.png");
    touch("Marbles.PNG");
    expect("marbles.png", "Marbles.PNG");
    /* Nothing but the extension is equal. */
    touch("a.bmp");
    expect("b.bmp", NULL);
    expect("bb.bmp", NULL);
    touch("b1.bmp");
    expect("b2.bmp", "b1.bmp");
}

TEST(folders_are_no_files)
{
    assert_int_equal(mkdir("Glass.png", 0700), 0);
    expect("glass.png", NULL);
    touch("glass.jpg");
    expect("glass.png", "glass.jpg");
}

TEST(long_names_are_left_out)
{
    char name[600];
    memset(name, 'n', sizeof name);
    memcpy(name + sizeof name - 5, ".png", 5);
    expect(name, NULL);
    memcpy(name + 251, ".pnG", 5);
    touch(name);
    memcpy(name + 251, ".png", 5);
    char *found = files_nearest(name);
    assert_non_null(found);
    assert_int_equal(strlen(found), 255);
    free(found);
}

/* Whatever the order in which the file system lists them. */
TEST(equally_near_names_have_an_order)
{
    char name[32];
    assert_int_equal(mkdir("large", 0700), 0);
    for (int i = 2999; i >= 0; --i) {
        snprintf(name, sizeof name, "large/map%04d.png", i);
        touch(name);
    }
    expect("large/map123.png", "map0123.png");
    expect("large/map99.png", "map0099.png");
    expect("large/map12345.png", "map1234.png");
    expect("large/map9.png", NULL);
}
