/* A batch of views: meshes seen by many cameras, drawn by a pool of threads into arrays. */
#ifndef PYTHON_VIEWS_H
#define PYTHON_VIEWS_H

#include <stdint.h>

#include <gnomon.h>

typedef enum views_shader {
    VIEWS_UNLIT,
    VIEWS_FLAT,
    VIEWS_GOURAUD,
    VIEWS_TOON,
    VIEWS_PHONG,
    VIEWS_BLINN_PHONG,
    VIEWS_NORMAL_COLOR
} views_shader;

/* One camera. */
typedef struct views_camera {
    gn_mat4 clip_from_world;
    gn_mat3 camera_from_world; /* for normals */
    gn_vec3 eye;               /* in the world */
    gn_vec3 forward;           /* unit length, in the world */

    /* A point at the distance d has the z of clip space z_per_distance * d + z and the w
     * w_per_distance * d + w. */
    double z_per_distance, z, w_per_distance, w;
} views_camera;

/* A mesh, and how it is drawn. */
typedef struct views_part {
    gn_mesh mesh;
    views_shader shader;
    gn_mat4 world_from_model;
    gn_mat3 normal_matrix;
    gn_material material;
    const int32_t *labels; /* of the faces; null: their numbers, from first_label */
    int32_t first_label;
} views_part;

/* What all views share, and the arrays that they are drawn to: of `count` pictures, one after the
 * other, each with its top row first. An array that is null is not drawn. `error` receives the
 * first fault, and `fault` its words if there are any. */
typedef struct views_job {
    const views_part *part; /* all are drawn into each picture */
    uint32_t part_count;
    gn_light light[GN_MAX_LIGHTS];
    uint32_t light_count;   /* 1 or more */
    uint32_t light_follows; /* bit i: the direction of light i is towards the camera */

    /* The shadow map of light 0: a square of depths, which is drawn first; null: no shadows. */
    float *shadow;
    uint32_t shadow_size;
    gn_mat4 shadow_from_world; /* the light's clip space */

    gn_raster raster;
    bool smooth_edges; /* colours are averages of GN_SAMPLES samples */
    float background[4];
    bool reversed; /* clip space has depths from 1, near, to 0, far; otherwise from -1 to 1 */
    bool normals_of_camera; /* normals are those of camera_from_world, not of the world */

    const views_camera *camera;
    uint32_t count, width, height;
    uint8_t *color;        /* 4 bytes a pixel */
    float *depth;          /* distances; 0 where nothing is drawn */
    float *normals;        /* 3 floats a pixel; 0 where nothing is drawn */
    int32_t *labels_drawn; /* -1 where nothing is drawn */

    gn_backend backend;
    gn_status error;
    const char *fault;
    bool is_empty; /* receives whether no view shows anything */
} views_job;

/* Returns the bytes of memory that views_draw needs with this many threads; SIZE_MAX if they are
 * too many for memory. */
size_t views_memory(const views_job *job, uint32_t threads);

/* Draws all views. Returns false if threads cannot be started, otherwise true; job->error says
 * whether the views are drawn. The caller has called views_enter. */
bool views_draw(views_job *job, void *memory, size_t size, uint32_t threads);

/* The bytes that hold a floating-point environment. */
enum { VIEWS_ENVIRONMENT = 64 };

/* Keeps the calling thread's floating-point environment and sets C's, which the library needs: a
 * program may have loaded code that flushes denormal numbers to zero. */
void views_enter(char environment[VIEWS_ENVIRONMENT]);

/* Restores an environment that views_enter kept. */
void views_leave(const char environment[VIEWS_ENVIRONMENT]);

#endif
