/* Processes that draw the scenes of the parity gate with the reference. */
#include "drawer.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

uint64_t drawer_scenes(const drawer_plan *plan, int class)
{
    return plan->scenes / CLASS_COUNT + ((uint64_t) class < plan->scenes % CLASS_COUNT);
}

/* Says whether a step went well; the text follows. */
static bool send_text(FILE *out, bool good, const char *text)
{
    char line[256];

    snprintf(line, sizeof line, "%s", text);
    return fputc(good, out) != EOF && fwrite(line, sizeof line, 1, out) == 1 && good;
}

/* Moves the memory of a frame's attachments; write_frame and read_frame have one order. */
static bool write_frame(FILE *out, const scene_frame *f)
{
    const size_t pixels = (size_t)f->width * f->height * f->images;

    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        const void *const color = scene_frame_color(f, i);

        if (color && fwrite(color, gn_format_size(scene_frame_format(f, i)), pixels, out) != pixels)
            return false;
    }
    return !f->depth || fwrite(f->depth, gn_format_size(f->depth_format), pixels, out) == pixels;
}

static bool read_frame(FILE *in, scene_frame *f)
{
    const size_t pixels = (size_t)f->width * f->height * f->images;

    for (int i = 0; i < GN_MAX_COLORS; ++i) {
        void *const color = scene_frame_color(f, i);

        if (color && fread(color, gn_format_size(scene_frame_format(f, i)), pixels, in) != pixels)
            return false;
    }
    return !f->depth || fread(f->depth, gn_format_size(f->depth_format), pixels, in) == pixels;
}

static bool draw_and_send(reference *r, const scene *s, FILE *out)
{
    char error[256] = "out of memory";
    scene_frame frame;
    bool good = scene_frame_allocate(&frame, s);

    if (good)
        good = reference_draw(r, s, &frame, error, sizeof error);
    good = send_text(out, good, error) && write_frame(out, &frame);
    scene_frame_free(&frame);
    return good;
}

/* Sends the scene's frame, and the frame of the scene without its draws. */
static bool draw_scene(reference *r, const scene *s, FILE *out)
{
    scene cleared = *s;

    cleared.draw_count = 0;
    return draw_and_send(r, s, out) && draw_and_send(r, &cleared, out);
}

static int draw_all(reference_profile profile, const drawer_plan *plan, FILE *out)
{
    char text[256] = "";
    reference *const r = reference_create(profile, text, sizeof text);

    if (r) {
        snprintf(text, sizeof text, "%s %s, %s", reference_driver_name(r),
                 reference_mesa_version(r), reference_renderer(r));
    }
    bool good = send_text(out, r != NULL, text);
    for (int c = 0; good && c < CLASS_COUNT; ++c) {
        for (uint64_t n = 0; good && n < drawer_scenes(plan, c); ++n) {
            scene *const s = generate_scene(plan->seed, (scene_class)c, n);

            good = draw_scene(r, s, out);
            scene_free(s);
        }
    }
    good = fclose(out) == 0 && good;
    reference_destroy(r);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

static bool receive_text(drawer *d)
{
    const int good = fgetc(d->frames);

    if (good != EOF && fread(d->text, sizeof d->text, 1, d->frames) == 1)
        return good;
    snprintf(d->text, sizeof d->text, "the process that draws has ended");
    return false;
}

bool drawer_start(drawer *d, reference_profile profile, const drawer_plan *plan)
{
    int ends[2];

    memset(d, 0, sizeof *d);
    if (pipe(ends) != 0) {
        snprintf(d->text, sizeof d->text, "%s", strerror(errno));
        return false;
    }
    fflush(NULL);
    const pid_t process = fork();
    if (process == 0) {
        close(ends[0]);
        _exit(draw_all(profile, plan, fdopen(ends[1], "wb")));
    }
    close(ends[1]);
    d->process = process;
    d->frames = fdopen(ends[0], "rb");
    if (process < 0 || !d->frames) {
        snprintf(d->text, sizeof d->text, "%s", strerror(errno));
        return false;
    }
    return receive_text(d);
}

bool drawer_receive(drawer *d, distance_side *side)
{
    char text[sizeof d->text];

    memcpy(text, d->text, sizeof text);
    if (!receive_text(d) || !read_frame(d->frames, &side->drawn) || !receive_text(d) ||
        !read_frame(d->frames, &side->cleared))
        return false;
    memcpy(d->text, text, sizeof text);
    return true;
}

void drawer_stop(drawer *d)
{
    if (d->frames)
        fclose(d->frames);
    if (d->process > 0) {
        kill((pid_t)d->process, SIGTERM);
        waitpid((pid_t)d->process, NULL, 0);
    }
}
