/* Counts of what became of triangles, in words. */
#include "counts.h"

#include <inttypes.h>
#include <stdlib.h>

#include "report.h"

/* Returns whether no fragment passed the depth test. Those that pass are nearer than the cleared
 * depth. */
static bool is_empty(const scene *s, const scene_frame *frame)
{
    const float *depth = frame->depth;
    const size_t count = (size_t)frame->width * frame->height * frame->images;
    for (size_t i = 0; i < count; ++i)
        if (depth[i] != s->clear_depth)
            return false;
    return true;
}

static void print_count(FILE *words, const char *what, uint64_t count, const char *of_these,
                        uint64_t part)
{
    fprintf(words, "%-26s%12" PRIu64, what, count);
    if (of_these != NULL)
        fprintf(words, "  of these %s: %" PRIu64, of_these, part);
    fputc('\n', words);
}

static void print_counts(FILE *words, const gn_draw_statistics *n, bool has_samples)
{
    print_count(words, "triangles", n->primitives, NULL, 0);
    print_count(words, "  drawn", n->drawn, "clipped", n->clipped);
    print_count(words, "  outside the view", n->outside, "behind the camera", n->behind);
    print_count(words, "  culled by facing", n->culled, NULL, 0);
    print_count(words, "  between pixels' centres", n->missed, NULL, 0);
    print_count(words, "  without area in the view", n->without_area, NULL, 0);
    print_count(words, "  not finite", n->not_finite, NULL, 0);
    print_count(words, has_samples ? "samples covered" : "pixels covered", n->samples_covered, NULL,
                0);
    print_count(words, "  passed the depth test", n->samples_passed, NULL, 0);
}

/* One way for triangles not to be drawn. */
typedef struct loss {
    uint64_t count;
    const char *of_one, *of_many;
} loss;

/* Writes how the triangles were lost: "all 12 triangles lie outside the view volume", or, if there
 * are several ways, "of 12 triangles 8 lie ..., 4 are ...". */
static void describe_losses(const loss *losses, size_t count, uint64_t all, char *text, size_t size)
{
    size_t end = 0;
    for (size_t i = 0; i < count; ++i) {
        const loss *l = losses + i;
        const char *verb = l->count == 1 ? l->of_one : l->of_many;
        if (l->count == 0 || end >= size)
            continue;
        if (l->count == all && all == 1)
            end += (size_t)snprintf(text + end, size - end, "the only triangle %s", verb);
        else if (l->count == all)
            end +=
                (size_t)snprintf(text + end, size - end, "all %" PRIu64 " triangles %s", all, verb);
        else if (end == 0)
            end += (size_t)snprintf(text, size, "of %" PRIu64 " triangles %" PRIu64 " %s", all,
                                    l->count, verb);
        else
            end += (size_t)snprintf(text + end, size - end, ", %" PRIu64 " %s", l->count, verb);
    }
}

/* Writes why nothing was drawn. */
static void describe(const gn_draw_statistics *n, bool has_samples, char *text, size_t size)
{
    const loss losses[] = {
        {n->behind, "lies behind the camera", "lie behind the camera"},
        {n->outside - n->behind, "lies outside the view volume", "lie outside the view volume"},
        {n->culled, "is culled by facing", "are culled by facing"},
        {n->missed, "lies between the centres of pixels", "lie between the centres of pixels"},
        {n->without_area, "has no area in this view", "have no area in this view"},
        {n->not_finite, "has coordinates that are not finite",
         "have coordinates that are not finite"},
        {n->drawn, "is in view but covers no pixel's centre",
         "are in view but cover no pixel's centre"},
    };
    if (n->primitives == 0)
        snprintf(text, size, "there are no triangles");
    else if (n->samples_covered > 0)
        snprintf(text, size, "all %" PRIu64 " covered %s failed the depth test", n->samples_covered,
                 has_samples ? "samples" : "pixels");
    else
        describe_losses(losses, sizeof losses / sizeof losses[0], n->primitives, text, size);
}

int counts_report(FILE *words, const char *name, bool is_asked, const picture *p,
                  gn_backend backend, scene_frame *frame)
{
    scene *const s = p->scene;
    const bool has_samples = scene_is_sampled(s);
    char why[512];
    if (!is_asked && !is_empty(s, frame))
        return 0;
    for (size_t i = 0; i < s->draw_count; ++i)
        s->draws[i].counted = picture_is_part(p, i);
    gn_status status = scene_draw_library(s, frame, 0, backend);
    if (status != GN_OK)
        return report_fault("drawing", "%s", gn_status_text(status));
    if (is_asked)
        print_counts(words, &frame->statistics, has_samples);
    if (frame->statistics.samples_passed == 0) {
        describe(&frame->statistics, has_samples, why, sizeof why);
        report_warning(name, "nothing was drawn: %s", why);
    }
    return 0;
}
