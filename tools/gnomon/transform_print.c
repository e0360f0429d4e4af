/* Prints matrices and places: nine significant digits, enough to restore every float. */
#include "transform.h"

#include <math.h>

/* Prints no negative zero. */
static double shown(float x)
{
    return (double)(x + 0.0f);
}

/* For row vectors the matrices are transposed. */
static void print_matrix(const char *name, const gn_mat4 *m, bool row_vectors)
{
    printf("%s\n", name);
    for (int row = 0; row < 4; ++row) {
        printf("       ");
        for (int column = 0; column < 4; ++column)
            printf(" %16.9g", shown(row_vectors ? m->m[row][column] : m->m[column][row]));
        printf("\n");
    }
}

static void print_transform(const char *name, const char *name_of_inverse, const gn_transform *t,
                            bool row_vectors)
{
    print_matrix(name, &t->matrix, row_vectors);
    print_matrix(name_of_inverse, &t->inverse, row_vectors);
}

static void print_matrices(const setup *s, const places *p)
{
    const bool rows = s->convention == CONVENTION_DIRECT3D;
    printf("matrices for %s\n",
           rows ? "row vectors, v * M, a row a line" : "column vectors, M * v, a row a line");
    print_transform("model", "inverse of model", &p->model, rows);
    print_transform("view", "inverse of view", &p->view, rows);
    print_transform("projection", "inverse of projection", &p->projection, rows);
    print_transform("viewport", "inverse of viewport", &p->viewport, rows);
    if (p->has_combined)
        print_transform("combined, from local to clip", "inverse of combined, from clip to local",
                        &p->combined, rows);
    else
        printf("combined: a number of it or of its inverse is too large for 32 bits\n");
    printf("\n");
}

static void print_vector(const char *name, gn_vec3 v, const char *ending)
{
    printf("  %-5s %16.9g %16.9g %16.9g%s", name, shown(v.x), shown(v.y), shown(v.z), ending);
}

static void print_outside(unsigned outside)
{
    static const char names[6][8] = {"left", "right", "bottom", "top", "near", "far"};
    const char *separator = "  outside the view volume: ";
    for (unsigned i = 0; i < 6; ++i) {
        if ((outside >> i & 1) != 0) {
            printf("%s%s", separator, names[i]);
            separator = ", ";
        }
    }
    if (outside != 0)
        printf("\n");
}

/* The far edges of the window belong to no pixel. */
static void print_pixel(const place *p, const float size[2])
{
    print_vector("pixel", p->pixel, "");
    if (p->outside == 0 && p->pixel.x < size[0] && p->pixel.y < size[1])
        printf("   in column %.0f, row %.0f", floor((double)p->pixel.x), floor((double)p->pixel.y));
    printf("\n");
}

static void print_place(const place *p, size_t number, const float size[2])
{
    printf("point %zu\n", number);
    print_vector("local", p->local, "\n");
    print_vector("world", p->world, "\n");
    print_vector("view", p->view, "\n");
    const gn_vec3 clip = {p->clip.x, p->clip.y, p->clip.z};
    print_vector("clip", clip, "");
    printf(" %16.9g\n", shown(p->clip.w));
    switch (p->division) {
    case DIVIDED:
        print_vector("NDC", p->ndc, "\n");
        print_pixel(p, size);
        print_outside(p->outside);
        break;
    case IN_EYE_PLANE:
        printf("  in the plane of the eye, w = 0: no NDC, no pixel\n");
        break;
    case BEHIND_EYE:
        printf("  behind the eye, w < 0: no NDC, no pixel\n");
        break;
    default:
        printf("  NDC and pixel are too large for 32-bit numbers\n");
        print_outside(p->outside);
    }
}

void transform_print(const setup *s, const places *p, bool with_matrices)
{
    if (with_matrices)
        print_matrices(s, p);
    if (p->count > 0)
        printf("        %16s %16s %16s %16s\n", "x", "y", "z", "w");
    for (size_t i = 0; i < p->count; ++i)
        print_place(&p->all[i], i + 1, s->given[KEYWORD_SCREEN].number);
}
