/* What the tests of readers share: reading a text or bytes, with the files that it names in memory,
 * and looking into the result. */
#ifndef MODEL_TEST_H
#define MODEL_TEST_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/unit.h"
#include "../../tools/models/read.h"

#define BUDGET ((uint64_t)64 << 20)

/* The files beside the model, up to one without a name. */
typedef struct test_file {
    const char *name;
    const char *text;
    size_t size; /* 0: that of the text */
} test_file;

static double read_crease = MODEL_CREASE_DEGREES;
static model read_model;
static model_messages read_messages;

static bool test_open(void *user, const char *name, model_file *file, const char **reason)
{
    for (const test_file *f = user; f != NULL && f->name != NULL; ++f)
        if (strcmp(f->name, name) == 0) {
            *file = (model_file){(const uint8_t *)f->text, f->size != 0 ? f->size : strlen(f->text),
                                 NULL};
            return true;
        }
    *reason = "No such file or directory";
    return false;
}

static void test_close(void *user, model_file *file)
{
    (void)user;
    (void)file;
}

static void forget_model(void)
{
    model_free(&read_model);
    model_messages_free(&read_messages);
}

/* For the end of a group of tests. */
static inline int forget_last_model(void **state)
{
    forget_model();
    return 0;
}

/* Writes a text with another end of its lines. */
static inline void end_lines(const char *text, const char *end, char *result)
{
    for (; *text != '\0'; ++text)
        if (*text == '\n')
            result += sprintf(result, "%s", end);
        else
            *result++ = *text;
    *result = '\0';
}

/* Reads a model; the one before is freed. The memory is exactly as long as the file, so that
 * sanitizers see what reads beyond its end. */
static inline bool read_bytes(model_format format, const char *name, const void *bytes, size_t size,
                              const test_file *files)
{
    const model_files from = {(void *)files, test_open, test_close};
    uint8_t *const exact = malloc(size);
    bool good;
    assert_true(size == 0 || exact != NULL);
    memcpy(exact, bytes, size);
    forget_model();
    good = model_read_bytes(name, format, exact, size, &from, BUDGET, read_crease, &read_model,
                            &read_messages);
    free(exact);
    return good;
}

/* Reads an OBJ text called x.obj. */
static inline bool read_obj_text(const char *text, const test_file *files)
{
    return read_bytes(MODEL_OBJ, "x.obj", text, strlen(text), files);
}

/* A binary file in the making. */
typedef struct writer {
    uint8_t bytes[2048];
    size_t size;
    bool is_big;
} writer;

static inline void write_bits(writer *w, uint64_t bits, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        w->bytes[w->size++] = (uint8_t)(bits >> 8 * (w->is_big ? size - 1 - i : i));
}

static inline void write_float(writer *w, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    write_bits(w, bits, sizeof bits);
}

/* Requires that a model is read with enough memory, and refused in words with any less. */
static inline void require_within_budget(model_format format, const char *name, const char *text,
                                         const test_file *files)
{
    const model_files from = {(void *)files, test_open, test_close};
    bool good = false;
    for (uint64_t budget = 0; !good; budget += 24) {
        forget_model();
        assert_true(budget < BUDGET);
        good = model_read_bytes(name, format, (const uint8_t *)text, strlen(text), &from, budget,
                                read_crease, &read_model, &read_messages);
        if (!good)
            assert_string_equal(read_messages.fault, "not enough memory");
    }
}

/* Whether a warning says this, as "file: text (count)". */
static inline bool has_warning(const char *expected)
{
    char text[1024];
    for (size_t i = 0; i < read_messages.warning_count; ++i) {
        const model_warning *const w = read_messages.warnings + i;
        snprintf(text, sizeof text, "%s: %s (%llu)", w->file, w->text,
                 (unsigned long long)w->count);
        if (strcmp(text, expected) == 0)
            return true;
    }
    return false;
}

static inline void print_messages(void)
{
    if (read_messages.fault_file[0] != '\0')
        print_message("fault: %s: %s\n", read_messages.fault_file, read_messages.fault);
    for (size_t i = 0; i < read_messages.warning_count; ++i)
        print_message("warning: %s: %s (%llu)\n", read_messages.warnings[i].file,
                      read_messages.warnings[i].text,
                      (unsigned long long)read_messages.warnings[i].count);
}

/* Requires that a model was read, with this many warnings, of which this is one; null: any. */
static inline void expect_warnings(bool good, size_t count, const char *warning)
{
    if (!good || read_messages.warning_count != count || (warning && !has_warning(warning)))
        print_messages();
    assert_true(good);
    assert_int_equal(read_messages.warning_count, count);
    assert_true(warning == NULL || has_warning(warning));
}

/* Requires that a model was read with this warning alone; null: with none. */
static inline void expect_read(bool good, const char *warning)
{
    expect_warnings(good, warning != NULL, warning);
}

/* Requires that a model was refused in these words, and that nothing is there. */
static inline void expect_fault(bool good, const char *fault)
{
    if (good || strcmp(read_messages.fault, fault) != 0)
        print_messages();
    assert_false(good);
    assert_string_equal(read_messages.fault, fault);
    assert_int_equal(read_model.part_count, 0);
}

static inline void expect_sizes(const model_part *p, model_kind kind, size_t vertices,
                                size_t indices)
{
    assert_int_equal(p->kind, kind);
    assert_int_equal(p->vertex_count, vertices);
    assert_int_equal(p->index_count, indices);
}

static inline void expect_floats(const float *values, const float *expected, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        assert_float_equal(values[i], expected[i], 1e-6f);
}

/* Requires triangles with this area together in the plane of x and y, each of which turns left. */
static inline void expect_area(const model_part *p, size_t triangles, double area)
{
    double sum = 0.0;
    assert_int_equal(p->kind, MODEL_TRIANGLES);
    assert_int_equal(p->index_count, 3 * triangles);
    for (size_t i = 0; i < p->index_count; i += 3) {
        const float *const a = p->positions + 3 * (size_t)p->indices[i];
        const float *const b = p->positions + 3 * (size_t)p->indices[i + 1];
        const float *const c = p->positions + 3 * (size_t)p->indices[i + 2];
        const double twice = ((double)b[0] - (double)a[0]) * ((double)c[1] - (double)a[1]) -
                             ((double)b[1] - (double)a[1]) * ((double)c[0] - (double)a[0]);
        assert_true(twice > 0.0);
        sum += 0.5 * twice;
    }
    assert_true(fabs(sum - area) < 1e-6);
}

static inline void expect_color(const model_part *p, size_t vertex, float r, float g, float b,
                                float a)
{
    const float expected[4] = {r, g, b, a};
    expect_floats(p->colors + 4 * vertex, expected, 4);
}

#endif
