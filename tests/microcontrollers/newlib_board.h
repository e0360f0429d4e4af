/* What a program with newlib needs to run on Arm's MPS2 boards in the emulator: the vector table,
 * the function that runs at reset, and the command line. Newlib's librdimon asks the emulator for
 * files and for the end of the program (semihosting); the linker script is newlib_board.ld. */
#ifndef PORTABILITY_BOARD_H
#define PORTABILITY_BOARD_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define BOARD_MOST_ARGUMENTS 16

extern uint32_t bss_begin[], bss_end[], stack_top[];

int main(int argc, char **argv);
void initialise_monitor_handles(void);
void board_run(void);
void _init(void);
void _fini(void);

/* Newlib calls these at the beginning and the end. */
void _init(void)
{
}

void _fini(void)
{
}

static char board_line[256];

/* Semihosting's SYS_GET_CMDLINE. Returns the number of words. */
static int board_arguments(char **argv)
{
    struct {
        char *text;
        uint32_t size;
    } block = {board_line, sizeof board_line};
    register int r0 __asm__("r0") = 0x15;
    register void *r1 __asm__("r1") = &block;
    int argc = 0;

    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    for (char *word = strtok(board_line, " "); word && argc < BOARD_MOST_ARGUMENTS;
         word = strtok(NULL, " "))
        argv[argc++] = word;
    return argc;
}

void board_run(void)
{
    char *argv[BOARD_MOST_ARGUMENTS + 1] = {NULL};

#if defined(__ARM_FP)
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* CPACR: the floating-point unit */
    __asm__ volatile("dsb\n isb" ::: "memory");
#endif
    for (uint32_t *p = bss_begin; p < bss_end; ++p)
        *p = 0;
    initialise_monitor_handles();
    const int argc = board_arguments(argv);
    exit(main(argc, argv));
}

__attribute__((section(".start"), used)) static const struct {
    uint32_t *stack;
    void (*reset)(void);
} board_vectors = {stack_top, board_run};

#endif
