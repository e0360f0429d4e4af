/* Known defects of Mesa 22.3: scenes of which its picture is not OpenGL's. The library
 * follows the specification there; reference/RULES.md has the measurements. */
#include "osmesa.h"

static bool has_flat_varying(const scene_draw *d)
{
    if (d->shader == SCENE_FLAT)
        return true;
    for (int c = 0; c < 4; ++c) {
        if (d->shader == SCENE_VERTEX_COLOR && d->state.interpolation[c] == GN_FLAT)
            return true;
    }
    return false;
}

/* The window y of a vertex but for the viewport's own scale: rounded alike, equal
 * positions stay equal, and others can only become equal, which errs on the safe side. */
static float device_y(const scene_draw *d, uint32_t vertex)
{
    const gn_attribute *a = &d->mesh.attribute[GN_ATTRIBUTE_POSITION];
    gn_vec4 p = {0.0f, 0.0f, 0.0f, 1.0f};
    float *const component[4] = {&p.x, &p.y, &p.z, &p.w};

    for (uint32_t c = 0; c < a->components; ++c)
        *component[c] = a->data[(size_t)vertex * a->components + c];
    const gn_vec4 clip = gn_mat4_multiply_vec4(&d->uniforms.light.clip_from_model, p);
    return clip.y * (1.0f / clip.w);
}

/* Of exactly three triangles without indices and without flat varyings, the third of
 * which has no height: Mesa draws none of the three. */
static bool is_nine_vertices(const scene_draw *d)
{
    if (d->state.topology != GN_TRIANGLES || d->mesh.index_format != GN_INDEX_NONE ||
        d->mesh.count / 3 != 3 || !d->mesh.attribute[GN_ATTRIBUTE_POSITION].data ||
        has_flat_varying(d))
        return false;

    float least = 0.0f, greatest = 0.0f;
    for (uint32_t v = 6; v < 9; ++v) {
        const float y = device_y(d, d->mesh.first + v);

        if (y != y)
            return true;
        least = v == 6 || y < least ? y : least;
        greatest = v == 6 || y > greatest ? y : greatest;
    }
    /* Within a few roundings of the viewport transformation of a large target. */
    return greatest - least <= 1e-5f;
}

const char *reference_defect(const scene *s)
{
    for (size_t i = 0; i < s->draw_count; ++i) {
        if (is_nine_vertices(&s->draws[i]))
            return "nine vertices";
    }
    return NULL;
}
