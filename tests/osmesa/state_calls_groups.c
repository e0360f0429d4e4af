/* The groups of calls, and the choice among them. */
#include "state_calls.h"

static const call_group groups[] = {
    {"of matrices ", MATRIX_KINDS, 30, call_matrix, NULL},
    {"of lights ", LIGHT_KINDS, 30, call_light, NULL},
    {"of textures ", TEXTURE_KINDS, 20, call_texture, NULL},
    {"of pixels ", PIXEL_KINDS, 20, call_pixels, NULL},
    {"of lists ", LIST_KINDS, 20, call_lists, NULL},
    {"of stacks ", STACK_KINDS, 30, call_stacks, NULL},
    {"of evaluators ", EVALUATOR_KINDS, 15, call_evaluators, NULL},
    {"of modes ", MODE_KINDS, 20, NULL, call_mode},
    {"of queries ", QUERY_KINDS, 15, NULL, call_query},
    {"", KINDS, 100, call_function, NULL},
};

const call_group *choose_group(random_source *r)
{
    const call_group *group = groups;

    while (!random_chance(r, group->chance))
        ++group;
    return group;
}

GLint call_of_group(const library *gl, const call_group *group, unsigned kind, const arguments *a)
{
    if (group->returning)
        return group->returning(gl, kind, a);
    group->call(gl, kind, a);
    return 0;
}
