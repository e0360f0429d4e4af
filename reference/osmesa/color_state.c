/* How colours go into the framebuffer, as OpenGL's state. */
#include "gl.h"

void reference_set_color_state(const gn_pipeline *p)
{
    const uint32_t written = ~p->color_write_disabled;

    glColorMask((written & GN_CHANNEL_RED) != 0, (written & GN_CHANNEL_GREEN) != 0,
                (written & GN_CHANNEL_BLUE) != 0, (written & GN_CHANNEL_ALPHA) != 0);
}
