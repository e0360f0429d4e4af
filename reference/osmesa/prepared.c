/* Scenes prepared for timing: uploaded once, drawn many times. The last frame can be read. */
#include "gl.h"

#include <stdlib.h>
#include <string.h>

reference_prepared *reference_prepare(reference *r, const scene *s, reference_depth depth,
                                      char *error, size_t error_size)
{
    reference_prepared *p = calloc(1, sizeof *p);

    if (!p) {
        reference_fail(error, error_size, "out of memory");
        return NULL;
    }
    p->scene = s;
    if (!framebuffer_create(&p->target, s, depth, r->is_pinned, error, error_size)) {
        free(p);
        return NULL;
    }
    p->draws = reference_upload(r, s, error, error_size);
    if (!p->draws) {
        framebuffer_destroy(&p->target);
        free(p);
        return NULL;
    }
    for (size_t i = 0; i < s->draw_count; ++i)
        reference_prepare_attributes(&s->draws[i], &p->draws[i]);
    glBindVertexArray(r->vertex_array);
    reference_draw_prepared(r, p);
    if (!reference_check("drawing a scene", error, error_size)) {
        reference_release(r, p);
        return NULL;
    }
    return p;
}

void reference_draw_prepared(reference *r, reference_prepared *p)
{
    const scene_draw *before = NULL;

    glBindFramebuffer(GL_FRAMEBUFFER, p->target.name);
    reference_clear(p->scene);
    for (size_t i = 0; i < p->scene->draw_count; ++i) {
        const scene_draw *const d = &p->scene->draws[i];

        reference_issue_prepared(p->scene, d, &p->draws[i], before,
                                 before ? &p->draws[i - 1] : NULL);
        before = d;
    }
    glBindVertexArray(r->vertex_array);
    glFinish();
}

bool reference_read_prepared(reference *r, reference_prepared *p, scene_frame *frame, char *error,
                             size_t error_size)
{
    glBindFramebuffer(GL_FRAMEBUFFER, p->target.name);
    frame->samples_passed = 0;
    memset(&frame->statistics, 0, sizeof frame->statistics);
    if (p->target.is_sampled)
        return reference_read_samples(r, p->scene, &p->target, frame, error, error_size);
    reference_read_image(p->scene, 0, frame);
    return reference_check("reading a scene", error, error_size);
}

void reference_release(reference *r, reference_prepared *p)
{
    (void)r;
    if (!p)
        return;
    reference_discard(p->draws, p->scene->draw_count);
    framebuffer_destroy(&p->target);
    if (p->to.name)
        framebuffer_destroy(&p->to);
    free(p);
}
