/* The window, by SDL2 opened at run time. */
#include "window.h"

#include "report.h"

#if GN_HAVE_SDL

#define SDL_MAIN_HANDLED
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <SDL2/SDL.h>

/* The functions in use. */
#define FUNCTIONS(X)                                                                               \
    X(SDL_Init)                                                                                    \
    X(SDL_Quit)                                                                                    \
    X(SDL_GetError)                                                                                \
    X(SDL_SetHint)                                                                                 \
    X(SDL_CreateWindow)                                                                            \
    X(SDL_DestroyWindow)                                                                           \
    X(SDL_GetWindowID)                                                                             \
    X(SDL_GetWindowSurface)                                                                        \
    X(SDL_UpdateWindowSurface)                                                                     \
    X(SDL_CreateRGBSurfaceWithFormatFrom)                                                          \
    X(SDL_SetSurfaceBlendMode)                                                                     \
    X(SDL_UpperBlit)                                                                               \
    X(SDL_FreeSurface)                                                                             \
    X(SDL_WaitEvent)                                                                               \
    X(SDL_PollEvent)                                                                               \
    X(SDL_PushEvent)                                                                               \
    X(SDL_GetModState)

#define DECLARE(name) __typeof__(name) *name;
static struct {
    FUNCTIONS(DECLARE)
} sdl;

static void *library;
static SDL_Window *window;

static int load(void)
{
    static const char file[] = "libSDL2-2.0.so.0";
    library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL)
        return report_fault("view", "there is no window without SDL2, and %s is not installed",
                            file);
    void *address;
    /* A pointer to an object is not one to a function, so its bytes are copied. */
#define FIND(name)                                                                                 \
    address = dlsym(library, #name);                                                               \
    if (address == NULL)                                                                           \
        return report_fault("view", "%s lacks the function %s", file, #name);                      \
    memcpy(&sdl.name, &address, sizeof address);
    FUNCTIONS(FIND)
    return 0;
}

/* Without a display, SDL2 may draw where nobody sees it. */
static bool has_display(void)
{
#ifdef __linux__
    return getenv("DISPLAY") != NULL || getenv("WAYLAND_DISPLAY") != NULL ||
           getenv("SDL_VIDEODRIVER") != NULL;
#else
    return true;
#endif
}

int window_open(const char *title, uint32_t width, uint32_t height)
{
    int fault = load();
    if (fault != 0)
        return fault;
    if (!has_display())
        return report_fault("view", "no window can be opened: neither DISPLAY nor WAYLAND_DISPLAY "
                                    "is set");
    /* The command's signals stay its own. */
    sdl.SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (sdl.SDL_Init(SDL_INIT_VIDEO) != 0)
        return report_fault("view", "no window can be opened: %s", sdl.SDL_GetError());
    window = sdl.SDL_CreateWindow(title, SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                  (int)width, (int)height, SDL_WINDOW_RESIZABLE);
    if (window == NULL)
        return report_fault("view", "no window can be opened: %s", sdl.SDL_GetError());
    return 0;
}

int window_show(const uint8_t *rgba, uint32_t width, uint32_t height)
{
    SDL_Surface *to = sdl.SDL_GetWindowSurface(window);
    SDL_Surface *from =
        sdl.SDL_CreateRGBSurfaceWithFormatFrom((void *)(uintptr_t)rgba, (int)width, (int)height, 32,
                                               (int)(4 * width), SDL_PIXELFORMAT_RGBA32);
    bool good = to != NULL && from != NULL;
    if (good)
        good = sdl.SDL_SetSurfaceBlendMode(from, SDL_BLENDMODE_NONE) == 0 &&
               sdl.SDL_UpperBlit(from, NULL, to, NULL) == 0 &&
               sdl.SDL_UpdateWindowSurface(window) == 0;
    int fault = good ? 0 : report_fault("view", "cannot be shown: %s", sdl.SDL_GetError());
    sdl.SDL_FreeSurface(from);
    return fault;
}

static int key_of(SDL_Keycode code)
{
    switch (code) {
    case SDLK_LEFT:
        return KEY_LEFT;
    case SDLK_RIGHT:
        return KEY_RIGHT;
    case SDLK_UP:
        return KEY_UP;
    case SDLK_DOWN:
        return KEY_DOWN;
    case SDLK_KP_PLUS:
        return '+';
    case SDLK_KP_MINUS:
        return '-';
    case SDLK_QUESTION:
        return 0; /* its text follows */
    default:
        return code > KEY_DOWN && code < 127 ? (int)code : 0;
    }
}

static window_event translate(const SDL_Event *e)
{
    window_event result = {WINDOW_NOTHING, 0, 0, 0};
    switch (e->type) {
    case SDL_QUIT:
        result.action = WINDOW_QUIT;
        break;
    case SDL_MOUSEMOTION:
        if (e->motion.state == 0)
            break;
        result.action =
            (e->motion.state & SDL_BUTTON_LMASK) != 0 && (sdl.SDL_GetModState() & KMOD_SHIFT) == 0
                ? WINDOW_DRAG
                : WINDOW_DRAG_PAN;
        result.x = e->motion.xrel;
        result.y = e->motion.yrel;
        break;
    case SDL_MOUSEWHEEL:
        result.action = WINDOW_WHEEL;
        result.y = e->wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -e->wheel.y : e->wheel.y;
        break;
    case SDL_KEYDOWN:
        result.action = WINDOW_KEY;
        result.key = key_of(e->key.keysym.sym);
        break;
    case SDL_TEXTINPUT:
        /* A key is called by what it sends without Shift, so no key is the question mark on most
         * keyboards. Of the other characters the keys are taken, and their text is left out. */
        if (strcmp(e->text.text, "?") == 0) {
            result.action = WINDOW_KEY;
            result.key = '?';
        }
        break;
    case SDL_WINDOWEVENT:
        if (e->window.event == SDL_WINDOWEVENT_EXPOSED)
            result.action = WINDOW_UNCOVERED;
        if (e->window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
            result.action = WINDOW_RESIZE;
            result.x = e->window.data1;
            result.y = e->window.data2;
        }
        break;
    default:
        break;
    }
    return result;
}

bool window_next(bool wait, window_event *result)
{
    SDL_Event e;
    if ((wait ? sdl.SDL_WaitEvent(&e) : sdl.SDL_PollEvent(&e)) == 0) {
        /* Waiting fails only if events cannot come any more. */
        *result = (window_event){wait ? WINDOW_QUIT : WINDOW_NOTHING, 0, 0, 0};
        return wait;
    }
    *result = translate(&e);
    return true;
}

void window_push(const window_event *event)
{
    SDL_Event e;
    memset(&e, 0, sizeof e);
    switch (event->action) {
    case WINDOW_DRAG:
    case WINDOW_DRAG_PAN:
        e.type = SDL_MOUSEMOTION;
        e.motion.state = event->action == WINDOW_DRAG ? SDL_BUTTON_LMASK : SDL_BUTTON_RMASK;
        e.motion.xrel = event->x;
        e.motion.yrel = event->y;
        break;
    case WINDOW_WHEEL:
        e.type = SDL_MOUSEWHEEL;
        e.wheel.y = event->y;
        break;
    case WINDOW_KEY:
        /* What a keyboard of the United States sends. */
        e.type = SDL_KEYDOWN;
        e.key.keysym.sym = event->key == '?' ? SDLK_SLASH : event->key;
        e.key.keysym.mod = event->key == '?' ? KMOD_LSHIFT : KMOD_NONE;
        sdl.SDL_PushEvent(&e);
        memset(&e, 0, sizeof e);
        e.type = SDL_TEXTINPUT;
        e.text.text[0] = (char)event->key;
        break;
    case WINDOW_RESIZE:
        e.type = SDL_WINDOWEVENT;
        e.window.event = SDL_WINDOWEVENT_SIZE_CHANGED;
        e.window.windowID = sdl.SDL_GetWindowID(window);
        e.window.data1 = event->x;
        e.window.data2 = event->y;
        break;
    default:
        e.type = SDL_QUIT;
        break;
    }
    sdl.SDL_PushEvent(&e);
}

void window_close(void)
{
    if (window != NULL)
        sdl.SDL_DestroyWindow(window);
    if (sdl.SDL_Quit != NULL)
        sdl.SDL_Quit();
    window = NULL;
}

#else

int window_open(const char *title, uint32_t width, uint32_t height)
{
    (void)title;
    (void)width;
    (void)height;
    return report_fault(
        "view", "this gnomon was built without SDL2: install libsdl2-dev and build it again");
}

int window_show(const uint8_t *rgba, uint32_t width, uint32_t height)
{
    (void)rgba;
    (void)width;
    (void)height;
    return 0;
}

bool window_next(bool wait, window_event *result)
{
    (void)wait;
    *result = (window_event){WINDOW_QUIT, 0, 0, 0};
    return true;
}

void window_push(const window_event *event)
{
    (void)event;
}

void window_close(void)
{
}

#endif
