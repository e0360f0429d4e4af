/* The command line as data. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <gnomon.h>

#include "picture_format.h"
#include "shading.h"

typedef enum command {
    COMMAND_RENDER = 1,
    COMMAND_COMPARE = 2,
    COMMAND_DEMO = 4,
    COMMAND_DIFF = 8,
    COMMAND_INFO = 16,
    COMMAND_SPIN = 32,
    COMMAND_VIEW = 64,
    COMMAND_EXPLAIN = 128,
    COMMAND_TRANSFORM = 256
} command;

/* The first kinds of maps have options. */
#define OPTIONS_MAP_COUNT (MAP_GLOW + 1)

/* A map as the options name it; zeroed, the model decides. */
typedef struct map_option {
    const char *file;
    bool none;
} map_option;

/* Which normal maps may be used. */
typedef enum normal_option { NORMALS_ANY = 0, NORMALS_TANGENT, NORMALS_WORLD } normal_option;

/* The filter of maps. */
typedef enum filter_option { FILTER_MIPMAP = 0, FILTER_LINEAR, FILTER_NEAREST } filter_option;

/* Whose view and clip space the camera has (gnomon/conventions.h). The world is right-handed in all
 * of them. */
typedef enum convention_option {
    CONVENTION_OPENGL = 0, /* right-handed, depth -w to w, y up */
    CONVENTION_DIRECT3D,   /* left-handed, depth 0 to w, y up */
    CONVENTION_VULKAN      /* right-handed, depth 0 to w, y down */
} convention_option;

/* The side from which the camera looks at the target. */
typedef enum side_option {
    SIDE_FRONT = 0,
    SIDE_BACK,
    SIDE_LEFT,
    SIDE_RIGHT,
    SIDE_TOP,
    SIDE_BOTTOM,
    SIDE_ISO /* from the front, the right and above alike */
} side_option;

/* How ranks divide one picture. */
typedef enum sort_option {
    SORT_FIRST = 0, /* by rows */
    SORT_LAST       /* by triangles */
} sort_option;

/* The largest width and height of render; what is beyond GN_MAX_SIZE is drawn in tiles. */
#define OPTIONS_MAX_TILED_SIZE (1 << 20)

/* The camera as the options describe it; camera_place chooses what is missing. */
typedef struct camera_options {
    convention_option convention;
    bool eye_given, target_given, up_given, side_given, fov_given, orthographic;
    side_option side; /* if the eye is not given */
    gn_vec3 eye, target, up;
    float fov_degrees;
    float orthographic_height; /* world units from the lower to the upper edge */
    bool near_given, far_given;
    float near, far;                    /* distances from the eye */
    double eye_rest[3], target_rest[3]; /* what eye and target lack: a float has few digits for
                                           places far from the origin */
} camera_options;

/* Limits of importing a model, all above 0. */
typedef struct import_limits {
    uint32_t seconds;
    uint32_t memory;     /* MiB */
    uint32_t output;     /* MiB of the imported data */
    uint32_t megapixels; /* of one map, in units of 2^20 pixels */
} import_limits;

/* Why something cannot be read within the limit of memory. */
#define IMPORT_NO_MEMORY "not enough memory (--import-memory)"

/* A model to draw, and its place: the transformations written before the first model, then those
 * written after this model. */
typedef struct model_option {
    const char *path;
    gn_transform world_from_model;
} model_option;

#define OPTIONS_MAX_MODELS 64

/* Two whole numbers. */
typedef struct pair_option {
    const char *typed; /* null: none */
    uint32_t x, y;
} pair_option;

typedef struct options {
    const char *model; /* the first model, or file of diff, info and transform; while several are
                          imported, the one that is */
    size_t model_count;
    model_option models[OPTIONS_MAX_MODELS];
    gn_transform world_from_all; /* the transformations before the first model */
    const char *output;
    bool format_given; /* for an output without a suffix */
    picture_format format;
    const char *depth_output;
    const char *views; /* a file of cameras; null: one picture */
    const char *picture_output;
    uint32_t width, height;
    uint32_t samples; /* per pixel: 1 or GN_SAMPLES */
    bool samples_given;
    sort_option sort;
    shading shading;
    bool shading_given; /* otherwise materials may choose others */
    map_option maps[OPTIONS_MAP_COUNT];
    normal_option normals;
    filter_option filter;
    bool filter_given; /* otherwise a model's own filters are used where it has some */
    bool opaque;       /* translucent materials are drawn as opaque ones */
    bool shadows;
    uint32_t exponent;   /* exponent of highlights; 0: the material's */
    uint32_t bands;      /* of the toon shader; 0: the shader's default */
    bool describes_maps; /* says what is known of maps, and goes on if one cannot be read */
    bool wireframe;
    bool points;
    float point_size;
    float crease_degrees; /* of normals that a file lacks */
    gn_cull cull;
    bool cull_given; /* otherwise materials decide */
    bool depth_test_disabled;
    bool statistics; /* counts of what became of the triangles are printed */
    camera_options camera;
    float background[4];
    bool background_is_gradient;
    float background_below[4]; /* of the bottom row; `background` is that of the top row */
    bool edges, edges_color_given;
    float edges_color[4];
    bool grid;
    bool light_given;
    gn_vec3 light; /* towards the light, in world space, of any length except 0 */
    uint32_t tessellation;
    const char *script;    /* of view; null: none */
    gn_vec3 axis;          /* of spin */
    uint32_t frames, rate; /* frames in all, and frames a second */
    pair_option pixel;     /* of explain, from the left and from the top */
    pair_option primitive; /* of explain: number of the draw, and in the draw */
    bool json;
    const char *state;  /* of the web page; null: models are drawn */
    bool matrices;      /* of transform */
    gn_backend backend; /* one that is available */
    import_limits limits;
} options;

typedef enum options_result {
    OPTIONS_READY,
    OPTIONS_HELP,
    OPTIONS_HELP_ALL,
    OPTIONS_WRONG
} options_result;

/* Takes the value of a camera's option: eye, target, up, fov, orthographic, near or far. Returns
 * false if it is none of these; otherwise *expected is null, or describes the expected value. */
bool options_take_camera(const char *name, const char *value, camera_options *camera,
                         const char **expected);

/* The format of the output: that of --format or of its name. */
picture_format options_format(const options *o);

/* Reads argv[1...]; argv[0] is the command's name. OPTIONS_HELP and OPTIONS_HELP_ALL: --help or
 * --help-all was given. OPTIONS_WRONG: the reason has been printed; *exit_status is EXIT_USAGE if
 * the command line is not valid and EXIT_FAULT if a value is impossible. Strings point into argv.
 */
options_result options_parse(command which, int argc, char **argv, options *result,
                             int *exit_status);

#endif
