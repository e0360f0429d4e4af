/* A window that shows a picture, by SDL2. SDL2 is opened at run time: the command starts where it
 * is not installed, and only this file knows it. A second program in place of that would need a way
 * to be found and a way to say that it is missing. */
#ifndef WINDOW_H
#define WINDOW_H

#include <stdbool.h>
#include <stdint.h>

typedef enum window_action {
    WINDOW_NOTHING,
    WINDOW_QUIT,
    WINDOW_DRAG,      /* with the left button: x, y are pixels to the right and down */
    WINDOW_DRAG_PAN,  /* with another button, or with shift: likewise */
    WINDOW_WHEEL,     /* y is steps away from the user */
    WINDOW_KEY,       /* key is a character, or one of those below */
    WINDOW_RESIZE,    /* x, y are width and height */
    WINDOW_UNCOVERED, /* the picture must be shown again */
    WINDOW_WAIT       /* only in scripts: x is milliseconds */
} window_action;

/* Keys without a character. */
enum { KEY_LEFT = 1, KEY_RIGHT, KEY_UP, KEY_DOWN, KEY_ESCAPE = 27 };

typedef struct window_event {
    window_action action;
    int x, y, key;
} window_event;

/* Opens the only window. Returns 0, or EXIT_FAULT with the reason printed. */
int window_open(const char *title, uint32_t width, uint32_t height);

/* Shows a picture of the window's size: red, green, blue, alpha of each pixel, top row first.
 * Returns 0, or EXIT_FAULT with the reason printed. */
int window_show(const uint8_t *rgba, uint32_t width, uint32_t height);

/* Waits for an event; with `wait` false, returns false if there is none yet. */
bool window_next(bool wait, window_event *result);

/* Sends an event to the window as if the user had caused it. */
void window_push(const window_event *event);

/* Harmless if no window is open. */
void window_close(void);

#endif
