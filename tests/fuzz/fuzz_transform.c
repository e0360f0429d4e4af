/* The text of `gnomon transform`: any text has places of its points, or one line that says what is
 * wrong with it; what is printed are numbers. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "report.h"
#include "transform.h"

static int lines;

static void count_line(const char *line)
{
    ++lines;
    FUZZ_REQUIRE(strncmp(line, "gnomon: setup", 13) == 0);
}

static bool is_finite(gn_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

/* The invariants of a point. */
static void require_sense(const place *p)
{
    FUZZ_REQUIRE(is_finite(p->local));
    FUZZ_REQUIRE(p->division != DIVIDED || (is_finite(p->ndc) && is_finite(p->pixel)));
    FUZZ_REQUIRE(p->division != DIVIDED || p->clip.w > 0.0f);
    FUZZ_REQUIRE(p->division != BEHIND_EYE || p->clip.w < 0.0f);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    FILE *const in = size ? fmemopen((void *)bytes, size, "r") : NULL;
    setup s;
    places p;

    if (!in)
        return -1;
    memset(&s, 0, sizeof s);
    memset(&p, 0, sizeof p);
    lines = 0;
    report_to(count_line);
    int fault = transform_read(in, "setup", &s);

    if (fault == 0)
        fault = transform_compute(&s, &p);
    FUZZ_REQUIRE((fault != 0) == (lines > 0) && lines < 2);
    if (fault == 0) {
        FUZZ_REQUIRE(p.count == s.points.count);
        for (size_t i = 0; i < p.count; ++i)
            require_sense(&p.all[i]);
        FUZZ_REQUIRE(freopen("/dev/null", "w", stdout) || true);
        transform_print(&s, &p, true);
    }
    transform_places_free(&p);
    transform_setup_free(&s);
    fclose(in);
    return 0;
}
