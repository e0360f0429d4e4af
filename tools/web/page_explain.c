/* A pixel of the page's picture, taken apart. */
#include "page_explain.h"

#include "page_parts.h"

#include "explain.h"

static prose json;

const char *page_explain(uint32_t x, uint32_t y)
{
    const scene *const s = page_scene();
    const camera *const seen = page_camera();
    explained e;

    page_begin();
    prose_free(&json);
    if (s == NULL || seen == NULL) {
        page_fail("there is no scene to explain: page_build comes first", (const char *)NULL);
        return NULL;
    }
    const explain_view view = {true, seen->y_down, seen->view_from_world};
    const char *const fault = explain_pixel(s, x, y, &view, NULL, &e);

    if (fault == NULL)
        explain_json(&e, &json);
    explain_free();
    if (fault != NULL || json.failed) {
        page_fail(fault != NULL ? fault : "there is not enough memory", (const char *)NULL);
        return NULL;
    }
    return prose_of(&json);
}
