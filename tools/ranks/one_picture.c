/* Draws one picture over ranks. */
#include "one_picture.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "bands.h"
#include "drawing.h"
#include "merge.h"
#include "picture.h"
#include "png_segments.h"
#include "ranks.h"
#include "report.h"
#include "rows_file.h"
#include "share_model.h"
#include "span.h"
#include "tiles.h"
#include "together.h"

/* A picture on its way. */
typedef struct job {
    options o; /* the shader is chosen */
    contents c;
    picture p;
    scene_frame frame;
    gn_workspace workspace;
    row_range rows; /* this rank's; of a picture in tiles, those that it draws at a time */
    bool is_drawn;  /* something passed the depth test in this rank's rows */
    tiling tiles;   /* of a picture in tiles */
} job;

static bool is_tiled(const options *o)
{
    return o->width > GN_MAX_SIZE || o->height > GN_MAX_SIZE;
}

bool one_picture_is_divided(const options *o)
{
    return ranks_count() > 1 || ranks_engine()[0] != '\0' || o->sort == SORT_LAST || is_tiled(o);
}

/* Refuses what cannot be drawn in this way. All ranks find the same. */
static int refuse(const options *o)
{
    const char *why = rows_file_refusal(options_format(o), o->width, o->height);
    if (why != NULL)
        return report_usage("render", "--size %ux%u: %s", (unsigned)o->width, (unsigned)o->height,
                            why);
    if (o->statistics)
        return report_usage("render", "--statistics cannot be used with %s",
                            is_tiled(o)            ? "sizes above 16384x16384"
                            : o->sort == SORT_LAST ? "--sort last"
                                                   : "ranks of MPI");
    if (o->sort == SORT_LAST && o->depth_test_disabled)
        return report_usage("render", "--sort last cannot be used with --no-depth-test, whose "
                                      "picture depends on the order of the triangles");
    if (o->sort == SORT_LAST && (o->edges || o->grid || o->background_is_gradient))
        return report_usage("render",
                            "--sort last cannot be used with %s, which every rank would "
                            "draw",
                            o->edges  ? "--edges"
                            : o->grid ? "--grid"
                                      : "two colours of --background");
    if (o->sort == SORT_LAST && is_tiled(o))
        return report_usage("render", "--sort last cannot be used with sizes above 16384x16384");
    return 0;
}

static int complete_shadows(shadow_pass *pass, int fault)
{
    fault = ranks_agree(fault);
    if (fault == 0)
        ranks_least(pass->frame.depth, (uint64_t)pass->frame.width * pass->frame.height);
    return fault;
}

/* Reads the model at rank 0, gives each rank what it draws, and builds its scene. */
static int describe(job *j)
{
    uint32_t number = 0;
    memset(&j->c, 0, sizeof j->c);
    int fault = ranks_agree(ranks_number() == 0 ? picture_import(&j->o, &j->c) : 0);
    if (fault != 0)
        return fault;
    if (ranks_number() == 0)
        number = (uint32_t)picture_shading(&j->o, &j->c);
    ranks_share(0, &number, sizeof number);
    j->o.shading = (shading)number;
    if (j->o.sort == SORT_LAST)
        share_model_in_parts(&j->c, &j->o);
    else if (ranks_count() > 1)
        share_model(&j->c);
    if (j->o.sort == SORT_LAST)
        j->c.complete_shadows = complete_shadows;
    together_begin();
    fault = together_end(picture_build(&j->o, &j->c, false, &j->p));
    import_free(&j->c.from);
    return fault;
}

/* A picture in tiles keeps only the result, with its samples resolved. */
static int allocate(job *j)
{
    scene kept = *j->p.scene;
    if (is_tiled(&j->o))
        kept.samples = 1;
    j->workspace.size = scene_workspace_size(&kept);
    j->workspace.backend = j->o.backend;
    j->workspace.memory = malloc(j->workspace.size);
    const bool good = j->workspace.memory != NULL && band_frame_reserve(&j->frame, &kept);
    return ranks_agree(good ? 0
                            : report_fault("--size", "not enough memory for %ux%u pixels",
                                           (unsigned)kept.width, (unsigned)kept.height));
}

static int checked(gn_status status)
{
    return status == GN_OK ? 0 : report_fault("drawing", "%s", gn_status_text(status));
}

/* Draws this rank's part of the triangles into all rows, and merges with the others. */
static int draw_last(job *j)
{
    const scene *s = j->p.scene;
    const char *why = merge_refusal(s);
    const bool is_translucent = j->p.blended_count > 0;
    int fault = why == NULL ? 0
                            : report_fault("--sort last", "cannot draw this: %s%s", why,
                                           is_translucent ? ": translucent materials; --opaque "
                                                            "draws them as opaque ones"
                                                          : "");
    fault = ranks_agree(fault);
    if (fault == 0)
        fault = checked(band_draw(s, (row_range){0, s->height}, &j->frame, &j->workspace));
    fault = ranks_agree(fault);
    return fault == 0 ? merge_bands(s, PNG_SEGMENT_ROWS, &j->frame) : fault;
}

/* Whether something passed the depth test in these rows: it is nearer than the cleared depth. */
static bool is_drawn(const scene *s, row_range rows, const scene_frame *frame)
{
    const size_t row = s->width, lowest = s->height - rows.first - rows.count;
    for (size_t i = 0; i < frame->images; ++i) {
        const float *depth = (const float *)frame->depth + (i * s->height + lowest) * row;
        for (size_t x = 0; x < rows.count * row; ++x)
            if (depth[x] != s->clear_depth)
                return true;
    }
    return false;
}

/* Draws this rank's rows. */
static int draw(job *j)
{
    const scene *s = j->p.scene;
    const uint32_t number = ranks_number(), count = ranks_count();
    int fault = 0;
    j->rows = band_of_rank(s->height, PNG_SEGMENT_ROWS, number, count);
    if (j->o.sort == SORT_LAST)
        fault = draw_last(j);
    else
        fault = checked(band_draw(s, j->rows, &j->frame, &j->workspace));
    if (fault == 0)
        fault = checked(band_resolve(s, j->rows, &j->frame));
    j->is_drawn = fault == 0 && is_drawn(s, j->rows, &j->frame);
    return ranks_agree(fault);
}

/* The files of a picture; the second one only if the depth is asked for. */
typedef struct files {
    rows_file color, depth;
    bool has_depth;
} files;

static int write_rows(files *f, const job *j)
{
    const int fault = rows_file_write(&f->color, j->rows, drawing_color_row, &j->frame);
    return fault == 0 && f->has_depth
               ? rows_file_write(&f->depth, j->rows, drawing_depth_row, &j->frame)
               : fault;
}

/* Draws and writes the strips of a picture in tiles: ranks take strips in turn. */
static int write_strips(files *f, job *j)
{
    const scene *s = j->p.scene;
    int fault = 0;
    j->tiles = tiles_divide(s, PNG_SEGMENT_ROWS, GN_MAX_SIZE);
    for (uint32_t first = 0; fault == 0; first += ranks_count()) {
        bool memory = false;
        j->rows = tiles_strip(s, &j->tiles, first + ranks_number());
        if (tiles_strip(s, &j->tiles, first).count == 0)
            break;
        fault = checked(tiles_draw(s, &j->tiles, j->rows, &j->frame, &j->workspace, &memory));
        if (memory)
            fault = report_fault("--size", "not enough memory for a tile");
        fault = ranks_agree(fault);
        if (fault != 0)
            break;
        j->is_drawn = j->is_drawn || is_drawn(s, j->rows, &j->frame);
        fault = write_rows(f, j);
        band_frame_forget(&j->frame, j->rows);
    }
    return fault;
}

/* Writes both files or neither, as picture_files_write does. */
static int write_files(job *j)
{
    const options *o = &j->o;
    files f;
    memset(&f, 0, sizeof f);
    f.has_depth = o->depth_output != NULL;
    int fault =
        rows_file_begin(&f.color, o->output, options_format(o), PNG_RGBA8, o->width, o->height);
    if (fault == 0 && f.has_depth)
        fault = rows_file_begin(&f.depth, o->depth_output, PICTURE_PNG, PNG_GREY16, o->width,
                                o->height);
    if (fault == 0)
        fault = is_tiled(o) ? write_strips(&f, j) : write_rows(&f, j);
    if (fault == 0)
        fault = rows_file_finish(&f.color);
    if (fault == 0 && f.has_depth)
        fault = rows_file_finish(&f.depth);
    if (fault == 0)
        fault = rows_file_rename(&f.color);
    if (fault == 0 && f.has_depth)
        fault = rows_file_rename(&f.depth);
    rows_file_abandon(&f.depth);
    rows_file_abandon(&f.color);
    return fault;
}

static void print_summary(const job *j)
{
    const options *o = &j->o;
    FILE *words = output_words(o->output, o->depth_output);
    const bool divides_triangles = o->sort == SORT_LAST;
    const uint64_t triangles = picture_primitive_count(&j->p);
    const uint64_t all = divides_triangles ? ranks_sum(triangles) : triangles;
    const span memory = span_of_memory();
    /* Without the depth test, and by translucent parts, no depth is written, so it tells nothing.
     */
    const bool writes_depth = !o->depth_test_disabled && j->p.blended_count == 0;
    const bool empty = ranks_largest(j->is_drawn) == 0 && writes_depth;
    if (ranks_number() != 0)
        return;
    picture_print_summary_of(words, o->output, &j->p, all);
    const uint32_t count = ranks_count();
    const char *const engine = ranks_engine();
    if (count == 1 && engine[0] == '\0')
        fprintf(words, "%smemory: ", is_tiled(o) ? "in tiles; " : "");
    else
        fprintf(words, "%u rank%s of %s, each with its part of the %s%s; memory of a rank: ",
                (unsigned)count, count == 1 ? "" : "s", engine,
                divides_triangles ? "triangles" : "rows", is_tiled(o) ? ", in tiles" : "");
    span_print(words, &memory);
    fputs(" MiB\n", words);
    if (empty)
        report_warning(o->output, "nothing was drawn");
}

static int run(job *j)
{
    int fault = describe(j);
    if (fault == 0)
        fault = allocate(j);
    if (fault == 0 && !is_tiled(&j->o))
        fault = draw(j);
    if (fault == 0)
        fault = write_files(j);
    if (fault == 0)
        print_summary(j);
    return fault;
}

int one_picture(const options *o, int fault)
{
    job *j = calloc(1, sizeof *j);
    if (fault == 0)
        fault = j == NULL ? report_fault("render", "not enough memory") : refuse(o);
    fault = ranks_agree(fault);
    if (fault == 0) {
        /* A file that grows too large is a fault that is reported, not a signal. */
        signal(SIGXFSZ, SIG_IGN);
        j->o = *o;
        fault = run(j);
        free(j->workspace.memory);
        band_frame_release(&j->frame);
        picture_free(&j->p);
    }
    free(j);
    return fault;
}
