/* What runs before `main` on a Cortex-M: the vector table, the floating-point unit, initial data.
 * Then the functions that compilers call even without a C library. */
#include <stddef.h>
#include <stdint.h>

/* The linker script defines where these begin and end. */
extern uint32_t data_begin[], data_end[], data_in_flash[], bss_begin[], bss_end[], stack_top[];

int main(void);
void reset(void);

/* A fault ends here: a debugger shows where it came from. */
static void fault(void)
{
    for (;;) {
    }
}

/* Ends the emulator, if there is one. On a device `main` does not return. */
static void leave(void)
{
    register int r0 __asm__("r0") = 0x18; /* semihosting: the program has ended */
    register uint32_t r1 __asm__("r1") = 0x20026;

    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    fault();
}

void reset(void)
{
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* CPACR: access to the floating-point unit */
    __asm__ volatile("dsb\n isb" ::: "memory");
#endif
    for (size_t i = 0; data_begin + i < data_end; ++i)
        data_begin[i] = data_in_flash[i];
    for (uint32_t *p = bss_begin; p < bss_end; ++p)
        *p = 0;
    main();
    leave();
}

/* Arm's first sixteen vectors: the stack, reset, then faults and system calls. Add those of your
 * interrupts. */
typedef union vector {
    uint32_t *stack;
    void (*function)(void);
} vector;

__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    {.stack = stack_top}, {.function = reset}, {.function = fault}, {.function = fault},
    {.function = fault},  {.function = fault}, {.function = fault}, {.stack = NULL},
    {.stack = NULL},      {.stack = NULL},     {.stack = NULL},     {.function = fault},
    {.function = fault},  {.stack = NULL},     {.function = fault}, {.function = fault},
};

void *memset(void *to, int value, size_t count);
void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memmove(void *to, const void *from, size_t count);

/* -fno-tree-loop-distribute-patterns keeps compilers from making calls of these loops. */
void *memset(void *to, int value, size_t count)
{
    unsigned char *p = to;

    while (count-- > 0)
        *p++ = (unsigned char)value;
    return to;
}

void *memmove(void *to, const void *from, size_t count)
{
    unsigned char *p = to;
    const unsigned char *q = from;

    if (p <= q)
        for (size_t i = 0; i < count; ++i)
            p[i] = q[i];
    else
        while (count-- > 0)
            p[count] = q[count];
    return to;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    return memmove(to, from, count);
}
