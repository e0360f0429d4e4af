/* Declarations of varyings in GLSL, each with its qualifiers.
 *
 * Mesa multiplies every smooth varying by w at the pixel's centre, though the varying is
 * interpolated at a centroid or at a sample (reference/RULES.md). So such varyings are declared
 * noperspective here: the vertex shader divides them by w, and the fragment shader multiplies them
 * by w at the same place. These are the operations of other smooth varyings. They differ in the
 * last bits if a primitive is clipped, unless all w are equal; the gate draws neither. */
#include "gl.h"

#include <string.h>

static const char *qualifier(gn_interpolation interpolation)
{
    switch (interpolation) {
    case GN_NOPERSPECTIVE:
        return "noperspective";
    case GN_FLAT:
        return "flat";
    case GN_SMOOTH:
        break;
    }
    return "smooth";
}

static const char *location_of(gn_interpolation_point location)
{
    return location == GN_AT_CENTROID ? "centroid" : location == GN_AT_SAMPLE ? "sample" : "";
}

static void append(char *text, const char *more)
{
    const size_t used = strlen(text);

    snprintf(text + used, LOCATED_TEXT - used, "%s", more);
}

bool reference_divides(const scene_draw *d)
{
    return scene_draw_is_located(d) && !scene_draw_has_one_w(d);
}

bool reference_divides_varying(const scene_draw *d, int varying)
{
    const bool is_located = d->state.program.interpolated_at[varying] != GN_AT_CENTER ||
                            scene_shades_samples(&d->state);

    return is_located && reference_divides(d);
}

void reference_declare(const scene_draw *d, int varying, gn_interpolation interpolation,
                       const char *type, const char *name, located_texts *texts)
{
    const gn_program *const program = &d->state.program;
    const char *const location = location_of(program->interpolated_at[varying]);
    const bool divides = interpolation == GN_SMOOTH && reference_divides_varying(d, varying);
    const char *const qualified = divides ? "noperspective" : qualifier(interpolation);
    char line[256];

    snprintf(line, sizeof line, "%s %s out %s %s;\n", qualified, location, type, name);
    append(texts->outs, line);
    snprintf(line, sizeof line, "%s %s in %s %s;\n", qualified, location, type, name);
    append(texts->ins, line);
    if (!divides)
        return;
    snprintf(line, sizeof line, "noperspective %s out float %s_w;\n", location, name);
    append(texts->outs, line);
    snprintf(line, sizeof line, "%s_w = 1.0 / gl_Position.w;\n%s = %s * %s_w;\n", name, name, name,
             name);
    append(texts->divisions, line);
    snprintf(line, sizeof line, "noperspective %s in float %s_w;\n#define %s (%s * (1.0 / %s_w))\n",
             location, name, name, name, name);
    append(texts->ins, line);
}
