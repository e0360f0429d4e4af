/* The boards that the emulator has, and a hosted machine: what runs before `main`, text, a count of
 * instructions, and how much of the stack was used. The linker script is board.ld. With -icount
 * shift=0 the emulator's clock advances by one nanosecond an instruction.
 *
 * BOARD_HAS_NEWLIB  defined on Arm: a C library prints and ends the program, by semihosting
 *                   (librdimon), and `main` gets a command line; nothing is measured */
#ifndef EMBEDDED_BOARD_H
#define EMBEDDED_BOARD_H

#include <stdint.h>

#if defined(__arm__) && !defined(__linux__)
#define BOARD_IS_BARE 1

/* Arm's semihosting: the debugger, or here the emulator, carries out the request. */
static void board_ask(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

#if !defined(BOARD_HAS_NEWLIB)
static void board_print(const char *text)
{
    board_ask(0x04, text);
}

static void board_exit(void)
{
    board_ask(0x18, (const void *)0x20026);
}

#define TIMER_CONTROL (*(volatile uint32_t *)0x40000000u)
#define TIMER_VALUE (*(volatile uint32_t *)0x40000004u)
#define TIMER_RELOAD (*(volatile uint32_t *)0x40000008u)

/* The board's timer 0 counts down from 2^32 - 1 at 25 MHz: once in 40 instructions. */
static inline void board_start(void)
{
    TIMER_CONTROL = 0;
    TIMER_RELOAD = 0xFFFFFFFF;
    TIMER_VALUE = 0xFFFFFFFF;
    TIMER_CONTROL = 1;
}

static inline uint32_t board_instructions(void)
{
    return (0xFFFFFFFF - TIMER_VALUE) * 40;
}
#endif

#elif defined(__riscv) && !defined(__linux__)
#define BOARD_IS_BARE 1

/* The transmitter of the board `virt`, and its device that ends the emulator. */
static void board_print(const char *text)
{
    while (*text)
        *(volatile uint8_t *)0x10000000u = (uint8_t)*text++;
}

static void board_exit(void)
{
    *(volatile uint32_t *)0x00100000u = 0x5555;
}

static uint32_t board_begin;

static uint32_t board_retired(void)
{
    uint32_t n;

    __asm__ volatile(".option push\n .option arch, +zicsr\n csrr %0, minstret\n .option pop"
                     : "=r"(n)
                     :
                     : "memory");
    return n;
}

static inline void board_start(void)
{
    board_begin = board_retired();
}

static inline uint32_t board_instructions(void)
{
    return board_retired() - board_begin;
}

#else
#include <stdio.h>

#define BOARD_IS_BARE 0

static void board_print(const char *text)
{
    fputs(text, stdout);
}

static inline void board_start(void)
{
}

static inline uint32_t board_instructions(void)
{
    return 0;
}

static inline void board_paint_stack(void)
{
}

static inline uint32_t board_stack(void)
{
    return 0;
}

static inline uint32_t board_loop(void)
{
    return 0;
}
#endif

#if !defined(BOARD_HAS_NEWLIB)
static inline void board_print_number(uint32_t n)
{
    char text[11];
    int at = 10;

    text[at] = 0;
    do {
        text[--at] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    board_print(text + at);
}
#endif

#if BOARD_IS_BARE
/* The ends of the sections of the linker script. */
extern uint32_t bss_begin[], bss_end[], stack_top[];

#if defined(BOARD_HAS_NEWLIB)
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv);
void initialise_monitor_handles(void);
void _init(void);
void _fini(void);

/* Newlib calls these at the beginning and the end. */
void _init(void)
{
}

void _fini(void)
{
}

static void board_main(void)
{
    static char line[256];
    const struct {
        char *text;
        uint32_t size;
    } block = {line, sizeof line};
    char *argv[17] = {NULL};
    int argc = 0;

    initialise_monitor_handles();
    board_ask(0x15, &block); /* SYS_GET_CMDLINE */
    for (char *word = strtok(line, " "); word && argc < 16; word = strtok(NULL, " "))
        argv[argc++] = word;
    exit(main(argc, argv));
}
#else
#define STACK_PAINT 0xA5A5A5A5u

/* Fills the free part of the stack with a pattern. */
static __attribute__((noinline, unused)) void board_paint_stack(void)
{
    for (uint32_t *p = bss_end; p < (uint32_t *)__builtin_frame_address(0) - 64; ++p)
        *(volatile uint32_t *)p = STACK_PAINT;
}

/* Returns the bytes of the stack in which the pattern is overwritten. */
static inline uint32_t board_stack(void)
{
    const uint32_t *p = bss_end;

    while (*(const volatile uint32_t *)p == STACK_PAINT)
        ++p;
    return (uint32_t)(stack_top - p) * 4;
}

/* Counts a loop of 3,000,000 instructions. */
static inline uint32_t board_loop(void)
{
    uint32_t n = 1000000;

    board_start();
#if defined(__arm__)
    __asm__ volatile("1: sub %0, #1\n cmp %0, #0\n bne 1b" : "+l"(n) : : "cc");
#else
    __asm__ volatile("1: addi %0, %0, -1\n nop\n bnez %0, 1b" : "+r"(n));
#endif
    return board_instructions();
}

int main(void);
void *memset(void *to, int value, __SIZE_TYPE__ count);
void *memcpy(void *restrict to, const void *restrict from, __SIZE_TYPE__ count);

/* Functions that compilers may call even without a C library. */
void *memset(void *to, int value, __SIZE_TYPE__ count)
{
    for (unsigned char *p = to; count > 0; --count)
        *p++ = (unsigned char)value;
    return to;
}

void *memcpy(void *restrict to, const void *restrict from, __SIZE_TYPE__ count)
{
    unsigned char *p = to;
    const unsigned char *q = from;

    for (; count > 0; --count)
        *p++ = *q++;
    return to;
}

static void board_main(void)
{
    main();
    board_exit();
}
#endif

void board_run(void);

void board_run(void)
{
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* CPACR: the floating-point unit */
    __asm__ volatile("dsb\n isb" ::: "memory");
#endif
    for (uint32_t *p = bss_begin; p < bss_end; ++p)
        *p = 0;
    board_main();
    for (;;) {
    }
}

#if defined(__arm__)
/* The vector table: where the stack begins, and the function that runs at reset. */
__attribute__((section(".start"), used)) static const struct {
    uint32_t *stack;
    void (*reset)(void);
} vectors = {stack_top, board_run};
#else
__attribute__((section(".start"), used, naked)) static void start(void)
{
    __asm__ volatile("la sp, stack_top\n j board_run");
}
#endif
#endif

#endif
