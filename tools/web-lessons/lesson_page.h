/* What a lesson's page calls in the module of the lessons. The page makes a new instance of the
 * module for every run, so that a lesson finds its variables as a program does when it begins. Then
 * it adds files, moves sliders, runs the lesson and reads what came out. */
#ifndef LESSON_PAGE_H
#define LESSON_PAGE_H

#include <stdbool.h>
#include <stdint.h>

enum { LESSON_DID_NOT_EXIT = -1 };

/* Room for a name, which the page writes with a zero behind it. */
char *lesson_name(void);

/* Makes a file of this name and size, or the input "stdin"; returns where the page writes its
 * bytes, or null if there is no room. */
uint8_t *lesson_add_file(const char *name, uint32_t size);

/* Says where the slider of this name stands. Sliders that are not moved have their first values.
 * Values outside a slider's range become its nearest end. Returns 1 if there are too many. */
int lesson_move_slider(const char *name, float value);

/* Runs a lesson; returns its status. It traps where the lesson calls exit: then
 * lesson_exit_status() is the status. After any other trap it is LESSON_DID_NOT_EXIT. */
int lesson_run(uint32_t number);
int lesson_exit_status(void);

/* The file that the lesson wrote, null if none. */
const uint8_t *lesson_picture(void);
uint32_t lesson_picture_size(void);

/* What it printed to stdout (0) or stderr (1). */
const uint8_t *lesson_printed(int errors);
uint32_t lesson_printed_size(int errors);

/* The sliders that it asked for, in their order. */
uint32_t lesson_slider_count(void);
const char *lesson_slider_name(uint32_t i);
float lesson_slider_value(uint32_t i);
float lesson_slider_first(uint32_t i);
float lesson_slider_least(uint32_t i);
float lesson_slider_most(uint32_t i);
bool lesson_slider_is_int(uint32_t i);

#endif
