/* The state: keys and values, read from text and written to it. */
#include <math.h>
#include <string.h>

#include "page_parts.h"
#include "page_text.h"
#include "shading.h"

#define LARGEST_SIZE 4096
#define DEFAULT_WIDTH 640
#define DEFAULT_HEIGHT 480
#define LEAST_FOV 0.1f
#define GREATEST_FOV 179.0f
#define GREATEST_BANDS 255

/* As far as a camera may go (orbit.c). */
#define GREATEST_DISTANCE 1e18f

typedef enum key {
    KEY_MODEL = 0,
    KEY_SIZE,
    KEY_SHADER,
    KEY_MAPS,
    KEY_FILTER,
    KEY_SAMPLES,
    KEY_POLYGONS,
    KEY_CULL,
    KEY_SHADOWS,
    KEY_BANDS,
    KEY_EXPONENT,
    KEY_CONVENTION,
    KEY_FOV,
    KEY_NEAR,
    KEY_FAR,
    KEY_EYE,
    KEY_TARGET,
    KEY_COUNT
} key;

/* The keys, and for those whose values are names, the names in the order of their numbers. */
static const struct {
    char name[16];
    char values[72];
} keys[KEY_COUNT] = {
    {"model", "teapot triangle square cube dropped"},
    {"size", ""},
    {"shader", ""},
    {"maps", "off on"},
    {"filter", "mipmap linear nearest"},
    {"samples", ""},
    {"polygons", "fill line point"},
    {"cull", "none back front"},
    {"shadows", "off on"},
    {"bands", ""},
    {"exponent", ""},
    {"convention", "opengl direct3d vulkan"},
    {"fov", ""},
    {"near", ""},
    {"far", ""},
    {"eye", ""},
    {"target", ""},
};

static page_settings now;
static bool has_begun;
static uint32_t changes, version;

static void set_defaults(page_settings *s)
{
    options *const o = &s->options;
    memset(s, 0, sizeof *s);
    s->maps = true;
    o->width = DEFAULT_WIDTH;
    o->height = DEFAULT_HEIGHT;
    o->samples = 1;
    o->shading = SHADING_PHONG;
    o->camera.up.y = 1.0f;
    o->camera.fov_degrees = 35.0f;
    gn_transform_identity(&o->world_from_all);
}

const page_settings *page_settings_now(void)
{
    if (!has_begun)
        set_defaults(&now);
    has_begun = true;
    return &now;
}

uint32_t page_state_version(void)
{
    return changes;
}

uint32_t page_settings_version(void)
{
    return version;
}

/* Whether two states differ in the camera, the convention and the picture's size at most. */
static bool same_contents(const page_settings *a, const page_settings *b)
{
    const options *const o = &a->options, *const p = &b->options;
    return a->model == b->model && a->maps == b->maps && o->shading == p->shading &&
           o->filter == p->filter && o->wireframe == p->wireframe && o->points == p->points &&
           o->cull == p->cull && o->shadows == p->shadows && o->bands == p->bands &&
           o->exponent == p->exponent;
}

static void take(const page_settings *s)
{
    if (!same_contents(page_settings_now(), s))
        ++version;
    now = *s;
    /* What is the default does not override a model's own shader, filters and culling. */
    now.options.shading_given = now.options.shading != SHADING_PHONG;
    now.options.cull_given = now.options.cull != GN_CULL_NONE;
    now.options.filter_given = now.options.filter != FILTER_MIPMAP;
    ++changes;
}

/* Name number i of a key, and its length; null if there are fewer. */
static const char *name_of(key k, uint32_t i, size_t *length)
{
    const char *name = keys[k].values;
    for (; i > 0 && *name != '\0'; --i) {
        name += strcspn(name, " ");
        name += *name == ' ';
    }
    *length = strcspn(name, " ");
    return *length > 0 ? name : NULL;
}

static int refuse(key k, const char *value, const char *wanted)
{
    char shown[48];
    strncpy(shown, value, sizeof shown - 1);
    shown[sizeof shown - 1] = '\0';
    return page_fail(keys[k].name, ": \"", shown, strlen(value) > strlen(shown) ? "..." : "",
                     "\" is not ", wanted, (const char *)NULL);
}

static int read_name(key k, const char *value, uint32_t *result)
{
    size_t length;
    const char *name;
    for (uint32_t i = 0; (name = name_of(k, i, &length)) != NULL; ++i) {
        if (strlen(value) == length && strncmp(value, name, length) == 0) {
            *result = i;
            return 0;
        }
    }
    static text wanted;
    text_clear(&wanted);
    text_add(&wanted, "one of: ");
    text_add(&wanted, keys[k].values);
    return refuse(k, value, text_of(&wanted));
}

static int read_shader(const char *value, shading *result)
{
    static text wanted;
    /* That one draws to a format of which the modules have no part. */
    const shading absent = SHADING_METALLIC_ROUGHNESS;
    if (shading_by_name(value, result) && *result != absent)
        return 0;
    text_clear(&wanted);
    text_add(&wanted, "one of:");
    for (int i = SHADING_AUTOMATIC + 1; i < SHADING_COUNT; ++i) {
        if (i == (int)absent)
            continue;
        text_add(&wanted, " ");
        text_add(&wanted, shading_traits_of((shading)i)->name);
    }
    return refuse(KEY_SHADER, value, text_of(&wanted));
}

static int read_size(const char *value, options *o)
{
    const char *from = value;
    uint32_t width, height;
    const bool good = text_read_whole(&from, LARGEST_SIZE, &width) && *from++ == 'x' &&
                      text_read_whole(&from, LARGEST_SIZE, &height) && *from == '\0';
    if (!good || width == 0 || height == 0)
        return refuse(KEY_SIZE, value, "WIDTHxHEIGHT, from 1x1 to 4096x4096");
    o->width = width;
    o->height = height;
    return 0;
}

static int read_samples(const char *value, uint32_t *result)
{
    if (strcmp(value, "1") != 0 && strcmp(value, "4") != 0)
        return refuse(KEY_SAMPLES, value, "1 or 4");
    *result = value[0] == '1' ? 1 : GN_SAMPLES;
    return 0;
}

static int read_whole(key k, const char *value, uint32_t least, uint32_t largest,
                      const char *wanted, uint32_t *result)
{
    const char *from = value;
    uint32_t number;
    if (!text_read_whole(&from, largest, &number) || *from != '\0' || number < least)
        return refuse(k, value, wanted);
    *result = number;
    return 0;
}

static int read_number(key k, const char *value, float least, float greatest, const char *wanted,
                       float *result)
{
    const char *from = value;
    float number;
    if (!text_read_float(&from, &number) || *from != '\0' || !(number >= least) ||
        !(number <= greatest))
        return refuse(k, value, wanted);
    *result = number;
    return 0;
}

static bool is_near(gn_vec3 v)
{
    return fabsf(v.x) <= GREATEST_DISTANCE && fabsf(v.y) <= GREATEST_DISTANCE &&
           fabsf(v.z) <= GREATEST_DISTANCE;
}

static int read_point(key k, const char *value, gn_vec3 *result)
{
    const char *from = value;
    gn_vec3 v;
    const bool good = text_read_float(&from, &v.x) && *from++ == ',' &&
                      text_read_float(&from, &v.y) && *from++ == ',' &&
                      text_read_float(&from, &v.z) && *from == '\0' && is_near(v);
    if (!good)
        return refuse(k, value, "X,Y,Z, three numbers of up to 1e18");
    *result = v;
    return 0;
}

static int set_name(page_settings *s, key k, const char *value)
{
    options *const o = &s->options;
    uint32_t i = 0;
    if (read_name(k, value, &i) != 0)
        return 1;
    switch (k) {
    case KEY_MODEL:
        s->model = (page_model_name)i;
        break;
    case KEY_MAPS:
        s->maps = i != 0;
        break;
    case KEY_FILTER:
        o->filter = (filter_option)i;
        break;
    case KEY_POLYGONS:
        o->wireframe = i == 1;
        o->points = i == 2;
        break;
    case KEY_CULL:
        o->cull = (gn_cull)i;
        break;
    case KEY_SHADOWS:
        o->shadows = i != 0;
        break;
    default:
        o->camera.convention = (convention_option)i;
        break;
    }
    return 0;
}

/* A value that is not empty. */
static int set_value(page_settings *s, key k, const char *value)
{
    options *const o = &s->options;
    camera_options *const c = &o->camera;
    const float tiny = 1e-18f;
    switch (k) {
    case KEY_SIZE:
        return read_size(value, o);
    case KEY_SHADER:
        return read_shader(value, &o->shading);
    case KEY_SAMPLES:
        return read_samples(value, &o->samples);
    case KEY_BANDS:
        return read_whole(k, value, 2, GREATEST_BANDS, "a whole number from 2 to 255", &o->bands);
    case KEY_EXPONENT:
        return read_whole(k, value, 1, MODEL_MAX_EXPONENT, "a whole number from 1 to 1024",
                          &o->exponent);
    case KEY_FOV:
        return read_number(k, value, LEAST_FOV, GREATEST_FOV, "an angle from 0.1 to 179 degrees",
                           &c->fov_degrees);
    case KEY_NEAR:
        c->near_given = true;
        return read_number(k, value, tiny, GREATEST_DISTANCE, "a distance above 0", &c->near);
    case KEY_FAR:
        c->far_given = true;
        return read_number(k, value, tiny, GREATEST_DISTANCE, "a distance above 0", &c->far);
    case KEY_EYE:
        c->eye_given = true;
        return read_point(k, value, &c->eye);
    case KEY_TARGET:
        c->target_given = true;
        return read_point(k, value, &c->target);
    default:
        return set_name(s, k, value);
    }
}

static void set_default(page_settings *s, key k)
{
    page_settings d;
    options *const o = &s->options;
    set_defaults(&d);
    switch (k) {
    case KEY_MODEL:
        s->model = d.model;
        break;
    case KEY_SIZE:
        o->width = d.options.width;
        o->height = d.options.height;
        break;
    case KEY_SHADER:
        o->shading = d.options.shading;
        break;
    case KEY_MAPS:
        s->maps = d.maps;
        break;
    case KEY_FILTER:
        o->filter = d.options.filter;
        break;
    case KEY_SAMPLES:
        o->samples = d.options.samples;
        break;
    case KEY_POLYGONS:
        o->wireframe = o->points = false;
        break;
    case KEY_CULL:
        o->cull = d.options.cull;
        break;
    case KEY_SHADOWS:
        o->shadows = d.options.shadows;
        break;
    case KEY_BANDS:
        o->bands = 0;
        break;
    case KEY_EXPONENT:
        o->exponent = 0;
        break;
    case KEY_CONVENTION:
        o->camera.convention = d.options.camera.convention;
        break;
    case KEY_FOV:
        o->camera.fov_degrees = d.options.camera.fov_degrees;
        break;
    case KEY_NEAR:
        o->camera.near_given = false;
        break;
    case KEY_FAR:
        o->camera.far_given = false;
        break;
    case KEY_EYE:
        o->camera.eye_given = false;
        break;
    default:
        o->camera.target_given = false;
        break;
    }
}

static int set_key(page_settings *s, const char *name, size_t length, const char *value)
{
    for (int k = 0; k < KEY_COUNT; ++k) {
        if (strlen(keys[k].name) != length || strncmp(keys[k].name, name, length) != 0)
            continue;
        if (*value != '\0')
            return set_value(s, (key)k, value);
        set_default(s, (key)k);
        return 0;
    }
    char shown[32];
    const size_t fits = length < sizeof shown ? length : sizeof shown - 1;
    memcpy(shown, name, fits);
    shown[fits] = '\0';
    return page_fail("\"", shown, fits < length ? "..." : "", "\" is no key of a state",
                     (const char *)NULL);
}

int page_set(const char *name, const char *value)
{
    page_settings s = *page_settings_now();
    page_begin();
    if (set_key(&s, name, strlen(name), value) != 0)
        return 1;
    take(&s);
    return 0;
}

int page_set_state(const char *state)
{
    static text value;
    page_settings s;
    page_begin();
    set_defaults(&s);
    for (const char *piece = state; *piece != '\0'; piece += *piece == '&') {
        const size_t length = strcspn(piece, "&"), name = strcspn(piece, "=&");
        const bool has_value = name < length;
        text_clear(&value);
        text_add_part(&value, piece + name + (has_value ? 1 : 0),
                      length - name - (has_value ? 1 : 0));
        if (value.failed)
            return page_fail("there is not enough memory", (const char *)NULL);
        if (length > 0 && set_key(&s, piece, name, text_of(&value)) != 0)
            return 1;
        piece += length;
    }
    take(&s);
    return 0;
}

int page_set_camera(gn_vec3 eye, gn_vec3 target)
{
    page_settings s = *page_settings_now();
    camera_options *const c = &s.options.camera;
    if (!is_near(eye) || !is_near(target))
        return page_fail("the camera would be too far away", (const char *)NULL);
    c->eye_given = c->target_given = true;
    c->eye = eye;
    c->target = target;
    take(&s);
    return 0;
}

static void begin_key(text *t, key k)
{
    if (t->length > 0)
        text_add(t, "&");
    text_add(t, keys[k].name);
    text_add(t, "=");
}

static void add_name(text *t, key k, uint32_t value, uint32_t by_default)
{
    size_t length;
    const char *const name = name_of(k, value, &length);
    if (value == by_default || name == NULL)
        return;
    begin_key(t, k);
    text_add_part(t, name, length);
}

static void add_whole(text *t, key k, uint32_t value, uint32_t by_default)
{
    if (value == by_default)
        return;
    begin_key(t, k);
    text_add_whole(t, value);
}

static void add_number(text *t, key k, bool given, float value)
{
    if (!given)
        return;
    begin_key(t, k);
    text_add_float(t, value);
}

static void add_point(text *t, key k, bool given, gn_vec3 value)
{
    add_number(t, k, given, value.x);
    if (!given)
        return;
    text_add(t, ",");
    text_add_float(t, value.y);
    text_add(t, ",");
    text_add_float(t, value.z);
}

const char *page_state(void)
{
    static text t;
    const page_settings *const s = page_settings_now();
    const options *const o = &s->options;
    const camera_options *const c = &o->camera;
    page_settings d;
    set_defaults(&d);
    text_clear(&t);
    add_name(&t, KEY_MODEL, (uint32_t)s->model, (uint32_t)d.model);
    if (o->width != d.options.width || o->height != d.options.height) {
        begin_key(&t, KEY_SIZE);
        text_add_whole(&t, o->width);
        text_add(&t, "x");
        text_add_whole(&t, o->height);
    }
    if (o->shading != d.options.shading) {
        begin_key(&t, KEY_SHADER);
        text_add(&t, shading_traits_of(o->shading)->name);
    }
    add_name(&t, KEY_MAPS, s->maps, d.maps);
    add_name(&t, KEY_FILTER, (uint32_t)o->filter, (uint32_t)d.options.filter);
    add_whole(&t, KEY_SAMPLES, o->samples, d.options.samples);
    add_name(&t, KEY_POLYGONS, o->wireframe ? 1 : o->points ? 2 : 0, 0);
    add_name(&t, KEY_CULL, (uint32_t)o->cull, (uint32_t)d.options.cull);
    add_name(&t, KEY_SHADOWS, o->shadows, d.options.shadows);
    add_whole(&t, KEY_BANDS, o->bands, 0);
    add_whole(&t, KEY_EXPONENT, o->exponent, 0);
    add_name(&t, KEY_CONVENTION, (uint32_t)c->convention, (uint32_t)d.options.camera.convention);
    add_number(&t, KEY_FOV, c->fov_degrees != d.options.camera.fov_degrees, c->fov_degrees);
    add_number(&t, KEY_NEAR, c->near_given, c->near);
    add_number(&t, KEY_FAR, c->far_given, c->far);
    add_point(&t, KEY_EYE, c->eye_given, c->eye);
    add_point(&t, KEY_TARGET, c->target_given, c->target);
    return t.failed ? "" : text_of(&t);
}
