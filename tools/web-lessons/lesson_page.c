/* Runs a lesson for its web page, with the sliders where the reader left them. */
#include "lesson_page.h"

#include <stddef.h>
#include <string.h>

enum { MOST_SLIDERS = 8, MOST_NAME = 128 };

typedef struct slider {
    char name[MOST_NAME];
    float value, first, least, most;
    bool is_int;
} slider;

static slider moved[MOST_SLIDERS], asked[MOST_SLIDERS];
static uint32_t moved_count, asked_count;
static char name_of_page[MOST_NAME];

char *lesson_name(void)
{
    return name_of_page;
}

int lesson_move_slider(const char *name, float value)
{
    if (moved_count == MOST_SLIDERS || strlen(name) >= MOST_NAME)
        return 1;
    strcpy(moved[moved_count].name, name);
    moved[moved_count++].value = value;
    return 0;
}

static float ask(const char *name, float value, float least, float most, bool is_int)
{
    float now = value;

    for (uint32_t i = 0; i < moved_count; ++i)
        if (strcmp(moved[i].name, name) == 0)
            now = moved[i].value >= least ? moved[i].value : least; /* also for NaN */
    now = now > most ? most : now;
    for (uint32_t i = 0; i < asked_count; ++i)
        if (strcmp(asked[i].name, name) == 0)
            return now;
    if (asked_count < MOST_SLIDERS && strlen(name) < MOST_NAME) {
        slider *s = &asked[asked_count++];

        strcpy(s->name, name);
        s->value = now;
        s->first = value;
        s->least = least;
        s->most = most;
        s->is_int = is_int;
    }
    return now;
}

/* What lesson.h declares. */
float lesson_slider(const char *name, float value, float least, float most);
int lesson_slider_int(const char *name, int value, int least, int most);

float lesson_slider(const char *name, float value, float least, float most)
{
    return ask(name, value, least, most, false);
}

int lesson_slider_int(const char *name, int value, int least, int most)
{
    return (int)ask(name, (float)value, (float)least, (float)most, true);
}

/* The lessons. The build compiles main of lesson NN as lesson_main_NN. */
#define LESSONS(X)                                                                                 \
    X(01)                                                                                          \
    X(02)                                                                                          \
    X(03)                                                                                          \
    X(04)                                                                                          \
    X(05)                                                                                          \
    X(06)                                                                                          \
    X(07)                                                                                          \
    X(08)                                                                                          \
    X(09)                                                                                          \
    X(10)                                                                                          \
    X(11)                                                                                          \
    X(12)                                                                                          \
    X(13)                                                                                          \
    X(14)                                                                                          \
    X(15)                                                                                          \
    X(16)                                                                                          \
    X(17)                                                                                          \
    X(18)                                                                                          \
    X(19)                                                                                          \
    X(20)                                                                                          \
    X(21)

#define DECLARE(number) int lesson_main_##number(int argc, char **argv);
LESSONS(DECLARE)

int lesson_run(uint32_t number)
{
    static char name[] = "lesson";
    char *arguments[] = {name, NULL};

    switch (number) {
#define RUN(n)                                                                                     \
    case 1##n - 100:                                                                               \
        return lesson_main_##n(1, arguments);
        LESSONS(RUN)
    }
    return 2; /* there is no such lesson */
}

uint32_t lesson_slider_count(void)
{
    return asked_count;
}

const char *lesson_slider_name(uint32_t i)
{
    return asked[i].name;
}

float lesson_slider_value(uint32_t i)
{
    return asked[i].value;
}

float lesson_slider_first(uint32_t i)
{
    return asked[i].first;
}

float lesson_slider_least(uint32_t i)
{
    return asked[i].least;
}

float lesson_slider_most(uint32_t i)
{
    return asked[i].most;
}

bool lesson_slider_is_int(uint32_t i)
{
    return asked[i].is_int;
}
