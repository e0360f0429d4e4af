/* Work on the colours of a row of pixels, which blits, resolving and levels consist of. */
#ifndef GN_KERNEL_SURFACES_ROW_WORK_H
#define GN_KERNEL_SURFACES_ROW_WORK_H

#include <stdbool.h>

#include <gnomon/lanes.h>
#include <gnomon/surface.h>

#include "../../config/features.h"

/* Columns of the destination whose texels are found at once, for every row. */
#if GN_IS_SMALL
#define TEXEL_COLUMNS 16
#else
#define TEXEL_COLUMNS 256
#endif

/* The texels' columns: bytes from the beginning of a row of the source. If texels are mixed there
 * are two of each, and the weight of the second. A span that begins at the last column has as many
 * lanes as any other. */
typedef struct texel_columns {
    int32_t offset[2][TEXEL_COLUMNS + GN_LANES];
    float weight[TEXEL_COLUMNS + GN_LANES];
    /* As many columns have two texels each that lie one after the other: 0 or all of them. */
    uint32_t side_by_side;
} texel_columns;

/* The texels' rows for the pixels of a span: bytes from the source's first row. */
typedef struct texel_rows {
    ptrdiff_t offset[2][GN_LANES];
    float weight[GN_LANES];
    bool is_one; /* all pixels have the same */
} texel_rows;

typedef enum row_kind {
    ROW_CONVERTS, /* pixels that lie side by side */
    ROW_AVERAGES, /* four samples of such pixels */
    ROW_GATHERS,  /* texels, one for each pixel */
    ROW_MIXES     /* the texels around each pixel */
} row_kind;

typedef struct row_work {
    row_kind kind;
    gn_format read, written;
    const unsigned char *from; /* the first pixel; the source's first row if texels are gathered */
    unsigned char *to;
    uint32_t count; /* pixels */

    ptrdiff_t sample_stride; /* of averages */

    /* For texels: pixel i takes column first + i. Unless all pixels take one row, there are at most
     * GN_LANES pixels. */
    const texel_columns *columns;
    uint32_t first;
    const texel_rows *rows;
    int dimensions;            /* in which texels are mixed: 1 to 3 */
    const unsigned char *next; /* with 3 dimensions, the second source's first row */
    float next_weight;         /* its weight */
} row_work;

#endif
