/* Clips lines to the view volume: each end moves to the plane that cuts off most of the line (Liang
 * and Barsky 1984), measured from that end. */
#ifndef GN_KERNEL_GEOMETRY_CLIP_LINE_INL
#define GN_KERNEL_GEOMETRY_CLIP_LINE_INL

#include "clip.inl"

/* Clips a line to the planes of its outcodes: `ends` become the ends of what is left. Returns false
 * if nothing is left or a distance is not finite. New vertices are in the clipper's scratch until
 * the next call. */
static inline bool clip_line(clipper *c, uint32_t ends[2])
{
    const uint32_t line[2] = {ends[0], ends[1]};
    const stored_vertex *const v[2] = {vertex_at(c->memory, line[0]),
                                       vertex_at(c->memory, line[1])};
    const uint32_t planes = v[0]->outcode | v[1]->outcode;
    float t[2] = {0.0f, 0.0f};

    c->used = 0;
    c->room = CLIP_ROOM;
    for (uint32_t plane = 0; plane < CLIP_PLANE_COUNT; ++plane) {
        if (!(planes >> plane & 1u))
            continue;

        const float distance[2] = {plane_distance(c, v[0], plane), plane_distance(c, v[1], plane)};
        for (int i = 0; i < 2; ++i) {
            const float own = distance[i];

            if (!is_finite(own))
                return false;
            if (own < 0.0f) {
                const float cut = own / (own - distance[1 - i]);
                t[i] = cut > t[i] ? cut : t[i];
            }
        }
        if (t[0] + t[1] >= 1.0f)
            return false;
    }
    for (int i = 0; i < 2; ++i)
        if (v[i]->outcode)
            ends[i] = interpolate_vertex(c, line[i], line[1 - i], t[i]);
    place_new_vertices(c);
    return true;
}

#endif
