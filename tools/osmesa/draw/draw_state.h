/* OpenGL's state as that of a draw of Gnomon. */
#ifndef OSMESA_DRAW_STATE_H
#define OSMESA_DRAW_STATE_H

#include "../context/gl_context.h"

/* Sets what draws write to; false if nothing is, with an error if the framebuffer is incomplete. */
bool set_target(context *gl, gn_target *target, const char *function);

/* Sets all of a pipeline but the program and the topology. */
void set_pipeline(const context *gl, gn_pipeline *pipeline);

/* Sets the scissor in rows of the target; not enabled, if the state's is not. */
void set_scissor(const context *gl, gn_scissor *scissor);

#endif
