/* The reference rasterizer: Mesa's llvmpipe draws a scene through OpenGL, which it is given by
 * OSMesa or by EGL (driver.h).
 *
 * The pinned profile makes Mesa's generated code the same on every x86 machine: the llvmpipe
 * driver, SSE4.1 without fused multiply-add, the accurate texture path, no shader cache. It is set
 * in the environment before the first context is created. The host profile uses the machine's own
 * instruction set, for measuring speed. The unpinned profile does so too, draws every scene, and
 * ignores the user's settings for Mesa. */
#ifndef OSMESA_REFERENCE_H
#define OSMESA_REFERENCE_H

#include "scene.h"

typedef enum reference_profile {
    REFERENCE_PINNED,
    REFERENCE_HOST,
    REFERENCE_UNPINNED
} reference_profile;

typedef struct reference reference;

/* Sets what Mesa reads of the environment when the first context is created: reference_create does
 * so by itself. */
void reference_set_environment(reference_profile profile);

/* Creates a reference; there can be one per process, because Mesa reads its environment once. The
 * context is current in the calling thread. Mesa must be 25.0.7, with which bit equality is
 * promised. Returns null on failure, with the reason in error. */
reference *reference_create(reference_profile profile, char *error, size_t error_size);
void reference_destroy(reference *r);

/* The driver: "OSMesa" or "Mesa EGL". */
const char *reference_driver_name(const reference *r);

/* The version from GL_VERSION, such as "25.0.7-2+deb13u1", and GL_RENDERER. */
const char *reference_mesa_version(const reference *r);
const char *reference_renderer(const reference *r);

/* Draws a scene into an allocated frame. Returns false with the reason (a GL error, a shader log,
 * an incomplete framebuffer) in error. */
bool reference_draw(reference *r, const scene *s, scene_frame *frame, char *error,
                    size_t error_size);

/* Blits as gn_blit does. Both surfaces are tightly packed, row 0 first, and the source and the
 * destination are different surfaces. Returns false with the reason in error. */
bool reference_blit(reference *r, const gn_surface *destination, const gn_rectangle *to,
                    const gn_surface *source, const gn_rectangle *from,
                    const gn_blit_options *options, char *error, size_t error_size);

/* The depth buffer of a scene whose drawing is timed. */
typedef enum reference_depth {
    REFERENCE_DEPTH_OF_SCENE,
    REFERENCE_DEPTH_24_STENCIL_8, /* OSMesa's default for a window */
    REFERENCE_DEPTH_FLOAT
} reference_depth;

/* For timing: uploads a scene once, draws it any number of times and waits for the end of each
 * frame; nothing is read back. The scene must stay unchanged until the release.
 * reference_read_prepared reads the frame drawn last, if the depth buffer is the scene's. */
typedef struct reference_prepared reference_prepared;
reference_prepared *reference_prepare(reference *r, const scene *s, reference_depth depth,
                                      char *error, size_t error_size);
void reference_draw_prepared(reference *r, reference_prepared *p);
bool reference_read_prepared(reference *r, reference_prepared *p, scene_frame *frame, char *error,
                             size_t error_size);
void reference_release(reference *r, reference_prepared *p);

/* For timing what is not a draw, on the frame of a prepared scene. reference_prepare_blit
 * makes the destination, of the size and formats of `to`, which must have one sample; the first
 * colour, depth and stencil are blitted or resolved if `to` has them. reference_make_levels makes
 * the levels of the texture of the first draw. Each waits for the end. What was made can be read;
 * levels are packed as in a texture's memory, without the first. */
bool reference_prepare_blit(reference_prepared *p, const scene *to, gn_blit_filter filter,
                            char *error, size_t error_size);
void reference_blit_prepared(reference_prepared *p);
bool reference_read_blit(reference_prepared *p, const scene *to, scene_frame *frame, char *error,
                         size_t error_size);
void reference_make_levels(reference_prepared *p);
bool reference_read_levels(reference_prepared *p, void *memory, char *error, size_t error_size);

#endif
