/* cglm with the instructions that every processor of the target has. */
#include "maths_cglm.h"

maths_pass *maths_cglm_baseline(maths_operation operation)
{
    return passes[operation];
}
