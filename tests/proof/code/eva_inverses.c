/* Inverses of all matrices, with infinities and NaN: no access is out of bounds or of what was not
 * written.
 * @sources: math/inverse.c math/adjugate.c math/matrix.c math/transform.c math/vector.c
 * @reaches: gn_mat4_invert_trs gn_mat4_invert_affine gn_mat4_normal_matrix
 * @reaches: gn_mat4_invert_orthographic gn_mat4_invert_perspective gn_mat3_invert gn_mat4_invert
 * @reaches: power_for write_affine determinant_again */
#include "eva.h"

#include <gnomon/inverse.h>
#include <gnomon/mat.h>
#include <gnomon/transform.h>

int main(void)
{
    gn_mat4 m, result;
    gn_mat3 m3, result3;
    float condition;
    gn_status status;

    for (int i = 0; i < 16; ++i)
        m.m[i / 4][i % 4] = any_float;
    for (int i = 0; i < 9; ++i)
        m3.m[i / 3][i % 3] = any_float;
    status = gn_mat4_invert_trs(&m, &result);
    status = gn_mat4_invert_affine(&m, &result);
    status = gn_mat4_normal_matrix(&m, &result3);
    status = gn_mat4_invert_orthographic(&m, &result);
    status = gn_mat4_invert_perspective(&m, &result);
    status = gn_mat3_invert(&m3, &result3, &condition);
    status = gn_mat4_invert(&m, &result, &condition);
    return status == GN_OK;
}
