/* The display: 240x240 pixels of two bytes each, the higher byte first. As displays with an ILI9341
 * or ST7789 do, it takes a stream of bytes: from the left pixel of the top row on, row after row
 * down. Write a display.c for your own display; the one here is for the emulator. */
#ifndef DISPLAY_H
#define DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

enum { DISPLAY_WIDTH = 240, DISPLAY_HEIGHT = 240 };

/* Begins a frame: the next byte belongs to the top left pixel. An ILI9341 takes the commands 0x2A
 * and 0x2B (columns and rows), then 0x2C (write memory). */
void display_begin(void);

/* Sends bytes. The memory may be drawn to again when the function has returned. */
void display_send(const void *bytes, uint32_t count);

/* Ends a frame. Returns whether another one is wanted; on a device it always is. */
bool display_end(void);

#endif
