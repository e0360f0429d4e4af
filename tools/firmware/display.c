/* A display for the emulator of Arm's board MPS2: a file, display.rgb565, which holds the bytes of
 * the last frame. It is written by semihosting: the emulator carries out what a BKPT instruction
 * asks for. Prints how many instructions each frame takes, from a timer of the board. */
#include "display.h"

enum { FRAMES = 3 };
enum { OPEN = 0x01, CLOSE = 0x02, WRITE_TEXT = 0x04, WRITE = 0x05 }; /* semihosting's operations */

static int file;
static int frames;

static int ask(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/* Timer 0 counts down at 25 MHz. With -icount shift=0 an instruction takes a nanosecond, so that
 * the timer counts once in 40 instructions. */
#define TIMER_CONTROL (*(volatile uint32_t *)0x40000000u)
#define TIMER_VALUE (*(volatile uint32_t *)0x40000004u)

static void print_number(uint32_t n)
{
    char text[11];
    int at = 10;

    text[at] = 0;
    do {
        text[--at] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    ask(WRITE_TEXT, text + at);
}

void display_begin(void)
{
    static const char name[] = "display.rgb565";
    const struct {
        const char *name;
        int mode, length;
    } open = {name, 5, sizeof name - 1}; /* mode 5 is "wb" */

    file = ask(OPEN, &open);
    TIMER_CONTROL = 0;
    TIMER_VALUE = 0xFFFFFFFFu;
    TIMER_CONTROL = 1;
}

void display_send(const void *bytes, uint32_t count)
{
    const struct {
        int file;
        const void *bytes;
        uint32_t count;
    } write = {file, bytes, count};

    ask(WRITE, &write);
}

bool display_end(void)
{
    const uint32_t thousands = (0xFFFFFFFFu - TIMER_VALUE) / 25;

    ask(CLOSE, &file);
    ask(WRITE_TEXT, "frame ");
    print_number((uint32_t)++frames);
    ask(WRITE_TEXT, ": ");
    print_number(thousands);
    ask(WRITE_TEXT, " thousand instructions\n");
    return frames < FRAMES;
}
