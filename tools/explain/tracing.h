/* What the draw that is being traced is about: the pixel, and what its stages have told so far. */
#ifndef EXPLAIN_TRACING_H
#define EXPLAIN_TRACING_H

#include "explain.h"
#include "names.h"
#include "told.h"

#define MOST_LABELS 64

typedef struct tracing {
    const struct scene *scene;
    uint32_t x, y;   /* the pixel: column and row of the scene */
    bool is_finding; /* only finds the primitives with fragments at the pixel */
    uint32_t *found; /* their numbers, in order */
    uint32_t found_count, found_room;

    bool is_asked; /* `asked` is told even without a fragment at the pixel */
    explain_primitive asked;
    bool is_missing;   /* what is being traced has no fragment at the pixel */
    bool edges_hold;   /* but its edge functions say that a sample is inside */
    bool covers_alone; /* but it has one when it is drawn alone */

    uint32_t draw, primitive;    /* that are being traced */
    uint32_t vertex[3], corners; /* the numbers of its vertices in the mesh */
    bool has_view;               /* whether the next two are known */
    gn_mat4 world_from_model, view_from_world;
    const gn_surface *color, *depth;
    bool fragment_is_told;       /* a fragment of the primitive has been told */
    uint32_t shared, shared_end; /* the report's stages of the primitive */

    /* Vertices by the addresses of their records: "v1", or "n1" for clipping's new ones. */
    struct {
        const void *record;
        char name[8];
    } label[MOST_LABELS];
    int labels;
} tracing;

extern tracing pixel;

#endif
