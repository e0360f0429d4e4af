/* Calls of raster positions, pixel transfers and pixel maps with random arguments. */
#include "state_calls.h"

void call_pixels(const library *gl, unsigned kind, const arguments *a)
{
    const GLfloat *const f = a->f;

    switch (kind) {
    case 0:
        gl->RasterPos2d(a->d[0], a->d[1]);
        break;
    case 1:
        gl->RasterPos3f(0.2f * f[0], 0.2f * f[1], 0.2f * f[2]);
        break;
    case 2:
        gl->RasterPos4f(f[0], f[1], f[2], 2.0f);
        break;
    case 3:
        gl->WindowPos2i(a->i[0], a->i[1]);
        break;
    case 4:
        gl->WindowPos3f(f[0], f[1], f[2]);
        break;
    default:
        gl->Bitmap(a->i[0] & 3, a->i[1] > 200 ? -1 : 0, f[0], f[1], f[2], f[3], NULL);
    }
}
