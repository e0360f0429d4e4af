/* The reference rasterizer: a scene drawn through OpenGL by OSMesa.
 *
 * The pinned profile makes Mesa's generated code the same on every x86 machine: the
 * llvmpipe driver, SSE4.1 without fused multiply-add, the accurate texture path, no
 * shader cache. It is set in the environment before the first context is created.
 * The host profile leaves the machine's own instruction set, for measuring speed. */
#ifndef OSMESA_REFERENCE_H
#define OSMESA_REFERENCE_H

#include "scene.h"

typedef enum reference_profile { REFERENCE_PINNED, REFERENCE_HOST } reference_profile;

typedef struct reference reference;

/* One a process: Mesa reads its environment once, and the context is current in the thread
 * that made it. Null on failure, with the reason in error. */
reference *reference_create(reference_profile profile, char *error, size_t error_size);
void reference_destroy(reference *r);

/* "22.3.6" and the like, from GL_VERSION; and GL_RENDERER. */
const char *reference_mesa_version(const reference *r);
const char *reference_renderer(const reference *r);

/* Whether the version is one the contract of bit equality is made for: 22.3.x. */
bool reference_is_contract_version(const reference *r);

/* Draws a scene into an allocated frame. False with the reason (a GL error, a shader log, an
 * incomplete framebuffer) in error. */
bool reference_draw(reference *r, const scene *s, scene_frame *frame, char *error,
                    size_t error_size);

/* Blits as gn_blit does. Both surfaces are tightly packed, row 0 first, and the source differs
 * from the destination. False with the reason in error. */
bool reference_blit(reference *r, const gn_surface *destination, const gn_rectangle *to,
                    const gn_surface *source, const gn_rectangle *from,
                    const gn_blit_options *options, char *error, size_t error_size);

/* The depth buffer of a scene that is measured. */
typedef enum reference_depth {
    REFERENCE_DEPTH_OF_SCENE,
    REFERENCE_DEPTH_24_STENCIL_8, /* what OSMesa gives a window that asks for nothing else */
    REFERENCE_DEPTH_FLOAT
} reference_depth;

/* For measuring: uploads a scene once, draws it any number of times and waits for the end
 * of each frame; nothing is read back. The scene must stay unchanged until the release. */
typedef struct reference_prepared reference_prepared;
reference_prepared *reference_prepare(reference *r, const scene *s, reference_depth depth,
                                      char *error, size_t error_size);
void reference_draw_prepared(reference *r, reference_prepared *p);
void reference_release(reference *r, reference_prepared *p);

#endif
