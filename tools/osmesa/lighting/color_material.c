/* Copies the current colour to the materials that follow it. */
#include "color_material.h"

#include <gl_registry.h>
#include <string.h>

unsigned material_colors(GLenum name)
{
    switch (name) {
    case GL_AMBIENT:
        return 1u << MATERIAL_AMBIENT;
    case GL_DIFFUSE:
        return 1u << MATERIAL_DIFFUSE;
    case GL_SPECULAR:
        return 1u << MATERIAL_SPECULAR;
    case GL_EMISSION:
        return 1u << MATERIAL_EMISSION;
    case GL_AMBIENT_AND_DIFFUSE:
        return 1u << MATERIAL_AMBIENT | 1u << MATERIAL_DIFFUSE;
    default:
        return 0;
    }
}

bool face_has_side(GLenum face, int side)
{
    return face == GL_FRONT_AND_BACK || face == (side ? GL_BACK : GL_FRONT);
}

bool follows_color(const lighting_state *lighting, int side, enum material_color name)
{
    return face_has_side(lighting->color_material_face, side) &&
           (material_colors(lighting->color_material_mode) >> name & 1u);
}

void follow_current_color(context *gl)
{
    lighting_state *const lighting = &gl->lighting;

    for (int side = 0; side < 2 && lighting->color_material; ++side)
        for (int name = 0; name < MATERIAL_COLORS; ++name)
            if (follows_color(lighting, side, (enum material_color)name))
                memcpy(lighting->material[side].color[name], gl->current.attribute[COLOR],
                       sizeof lighting->material[side].color[name]);
}
