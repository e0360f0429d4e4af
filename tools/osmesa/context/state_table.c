/* The rows of the table, and how they are found. */
#include "state_table.h"

#include <gl_registry.h>
#include <string.h>

#include "../evaluators/bezier.h"
#include "../lists/display_lists.h"
#include "computed_state.h"

#define AT(member) offsetof(context, member)
#define ROW(name, kind, count, member)                                                             \
    {                                                                                              \
        name, kind, count, AT(member), NULL, 0, false                                              \
    }
#define SWITCH(name, member) ROW(name, STATE_SWITCH, 1, member)
#define CLIENT_SWITCH(name, member) ROW(name, STATE_CLIENT_SWITCH, 1, member)
#define BOOLEAN(name, member) ROW(name, STATE_BOOLEAN, 1, member)
#define INTEGER(name, member) ROW(name, STATE_INTEGER, 1, member)
#define STENCIL(name, member) ROW(name, STATE_STENCIL, 1, member)
#define UNSIGNED(name, member) ROW(name, STATE_UNSIGNED, 1, member)
#define FLOAT(name, member) ROW(name, STATE_FLOAT, 1, member)
#define CONSTANT(name, value)                                                                      \
    {                                                                                              \
        name, STATE_CONSTANT, 1, value, NULL, 0, false                                             \
    }
#define COMPUTED(name, count, function)                                                            \
    {                                                                                              \
        name, STATE_COMPUTED, count, 0, function, 0, false                                         \
    }
#define COMPUTED_FLOAT(name, count, function)                                                      \
    {                                                                                              \
        name, STATE_COMPUTED_FLOAT, count, 0, function, 0, false                                   \
    }
#define COMPUTED_FRACTION(name, count, function)                                                   \
    {                                                                                              \
        name, STATE_COMPUTED_FRACTION, count, 0, function, 0, false                                \
    }
#define EVALUATOR(name1, name2, i)                                                                 \
    SWITCH(name1, evaluator.map1[i]), SWITCH(name2, evaluator.map2[i])
#define ARRAY(i) arrays.array[i]
#define PER_UNIT(name, kind, count, member, step)                                                  \
    {                                                                                              \
        name, kind, count, AT(member), NULL, step, false                                           \
    }
#define COORDINATE_ARRAY(name, kind, member)                                                       \
    {                                                                                              \
        name, kind, 1, AT(ARRAY(TEXTURE_COORDINATE_ARRAY).member), NULL, sizeof(vertex_array),     \
            true                                                                                   \
    }

static const state_row rows[] = {
    /* Current values */
    ROW(GL_CURRENT_COLOR, STATE_FRACTION, 4, current.attribute[COLOR]),
    COMPUTED_FRACTION(GL_CURRENT_SECONDARY_COLOR, 4, computed_secondary_color),
    ROW(GL_CURRENT_NORMAL, STATE_FRACTION, 3, current.attribute[NORMAL]),
    PER_UNIT(GL_CURRENT_TEXTURE_COORDS, STATE_FLOAT, 4, current.attribute[TEXTURE_COORDINATE],
             sizeof(GLfloat[4])),
    COMPUTED_FLOAT(GL_CURRENT_FOG_COORDINATE, 1, computed_fog_coordinate),
    BOOLEAN(GL_EDGE_FLAG, current.edge_flag),
    FLOAT(GL_CURRENT_INDEX, current.index),
    ROW(GL_CURRENT_RASTER_POSITION, STATE_FLOAT, 4, raster_position.position),
    ROW(GL_CURRENT_RASTER_COLOR, STATE_FRACTION, 4, raster_position.color),
    ROW(GL_CURRENT_RASTER_SECONDARY_COLOR, STATE_FRACTION, 4, raster_position.secondary_color),
    FLOAT(GL_CURRENT_RASTER_DISTANCE, raster_position.distance),
    CONSTANT(GL_CURRENT_RASTER_INDEX, 1),
    PER_UNIT(GL_CURRENT_RASTER_TEXTURE_COORDS, STATE_FLOAT, 4, raster_position.coordinate,
             sizeof(GLfloat[4])),
    BOOLEAN(GL_CURRENT_RASTER_POSITION_VALID, raster_position.is_valid),

    /* Transformation */
    UNSIGNED(GL_MATRIX_MODE, transform.mode),
    COMPUTED_FRACTION(GL_MODELVIEW_MATRIX, 16, computed_modelview),
    COMPUTED_FRACTION(GL_PROJECTION_MATRIX, 16, computed_projection),
    COMPUTED_FRACTION(GL_TEXTURE_MATRIX, 16, computed_texture_matrix),
    COMPUTED_FRACTION(GL_TRANSPOSE_MODELVIEW_MATRIX, 16, computed_transposed_modelview),
    COMPUTED_FRACTION(GL_TRANSPOSE_PROJECTION_MATRIX, 16, computed_transposed_projection),
    COMPUTED_FRACTION(GL_TRANSPOSE_TEXTURE_MATRIX, 16, computed_transposed_texture_matrix),
    INTEGER(GL_MODELVIEW_STACK_DEPTH, transform.modelview.depth),
    INTEGER(GL_PROJECTION_STACK_DEPTH, transform.projection.depth),
    PER_UNIT(GL_TEXTURE_STACK_DEPTH, STATE_INTEGER, 1, transform.texture[0].depth,
             sizeof(matrix_stack)),
    CONSTANT(GL_MAX_MODELVIEW_STACK_DEPTH, MODELVIEW_DEPTH),
    CONSTANT(GL_MAX_PROJECTION_STACK_DEPTH, PROJECTION_DEPTH),
    CONSTANT(GL_MAX_TEXTURE_STACK_DEPTH, TEXTURE_DEPTH),
    ROW(GL_VIEWPORT, STATE_INTEGER, 4, transform.viewport),
    UNSIGNED(GL_CLIP_ORIGIN, transform.clip_origin),
    UNSIGNED(GL_CLIP_DEPTH_MODE, transform.clip_depth),
    ROW(GL_DEPTH_RANGE, STATE_FRACTION, 2, transform.depth_range),
    SWITCH(GL_CLIP_PLANE0, transform.clip_plane_enabled[0]),
    SWITCH(GL_CLIP_PLANE1, transform.clip_plane_enabled[1]),
    SWITCH(GL_CLIP_PLANE2, transform.clip_plane_enabled[2]),
    SWITCH(GL_CLIP_PLANE3, transform.clip_plane_enabled[3]),
    SWITCH(GL_CLIP_PLANE4, transform.clip_plane_enabled[4]),
    SWITCH(GL_CLIP_PLANE5, transform.clip_plane_enabled[5]),
    SWITCH(GL_CLIP_DISTANCE6, transform.clip_plane_enabled[6]),
    SWITCH(GL_CLIP_DISTANCE7, transform.clip_plane_enabled[7]),
    CONSTANT(GL_MAX_CLIP_PLANES, CLIP_PLANES),
    SWITCH(GL_NORMALIZE, transform.normalize),
    SWITCH(GL_RESCALE_NORMAL, transform.rescale_normal),

    /* Lighting */
    SWITCH(GL_LIGHTING, lighting.enabled),
    SWITCH(GL_LIGHT0, lighting.light[0].enabled),
    SWITCH(GL_LIGHT1, lighting.light[1].enabled),
    SWITCH(GL_LIGHT2, lighting.light[2].enabled),
    SWITCH(GL_LIGHT3, lighting.light[3].enabled),
    SWITCH(GL_LIGHT4, lighting.light[4].enabled),
    SWITCH(GL_LIGHT5, lighting.light[5].enabled),
    SWITCH(GL_LIGHT6, lighting.light[6].enabled),
    SWITCH(GL_LIGHT7, lighting.light[7].enabled),
    SWITCH(GL_COLOR_MATERIAL, lighting.color_material),
    UNSIGNED(GL_COLOR_MATERIAL_FACE, lighting.color_material_face),
    UNSIGNED(GL_COLOR_MATERIAL_PARAMETER, lighting.color_material_mode),
    ROW(GL_LIGHT_MODEL_AMBIENT, STATE_FRACTION, 4, lighting.ambient),
    BOOLEAN(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting.local_viewer),
    BOOLEAN(GL_LIGHT_MODEL_TWO_SIDE, lighting.two_side),
    UNSIGNED(GL_LIGHT_MODEL_COLOR_CONTROL, lighting.color_control),

    /* Rasterization */
    UNSIGNED(GL_SHADE_MODEL, lighting.shade_model),
    FLOAT(GL_POINT_SIZE, raster.point_size),
    FLOAT(GL_POINT_SIZE_MIN, raster.point_size_min),
    FLOAT(GL_POINT_SIZE_MAX, raster.point_size_max),
    FLOAT(GL_POINT_FADE_THRESHOLD_SIZE, raster.point_fade_threshold),
    ROW(GL_POINT_DISTANCE_ATTENUATION, STATE_FLOAT, 3, raster.point_attenuation),
    COMPUTED_FLOAT(GL_SMOOTH_POINT_SIZE_RANGE, 2, computed_point_size_range),
    COMPUTED_FLOAT(GL_ALIASED_POINT_SIZE_RANGE, 2, computed_point_size_range),
    COMPUTED_FLOAT(GL_SMOOTH_POINT_SIZE_GRANULARITY, 1, computed_granularity),
    FLOAT(GL_LINE_WIDTH, raster.line_width),
    COMPUTED_FLOAT(GL_SMOOTH_LINE_WIDTH_RANGE, 2, computed_line_width_range),
    COMPUTED_FLOAT(GL_ALIASED_LINE_WIDTH_RANGE, 2, computed_line_width_range),
    COMPUTED_FLOAT(GL_SMOOTH_LINE_WIDTH_GRANULARITY, 1, computed_granularity),
    INTEGER(GL_LINE_STIPPLE_PATTERN, raster.stipple_pattern),
    INTEGER(GL_LINE_STIPPLE_REPEAT, raster.stipple_factor),
    SWITCH(GL_POINT_SMOOTH, raster.point_smooth),
    SWITCH(GL_LINE_SMOOTH, raster.line_smooth),
    SWITCH(GL_LINE_STIPPLE, raster.line_stipple),
    SWITCH(GL_POLYGON_SMOOTH, raster.polygon_smooth),
    SWITCH(GL_POLYGON_STIPPLE, raster.polygon_stipple),
    SWITCH(GL_CULL_FACE, raster.cull),
    UNSIGNED(GL_CULL_FACE_MODE, raster.cull_face),
    UNSIGNED(GL_FRONT_FACE, raster.front_face),
    ROW(GL_POLYGON_MODE, STATE_UNSIGNED, 2, raster.polygon_mode),
    SWITCH(GL_POLYGON_OFFSET_FILL, raster.offset_fill),
    SWITCH(GL_POLYGON_OFFSET_LINE, raster.offset_line),
    SWITCH(GL_POLYGON_OFFSET_POINT, raster.offset_point),
    FLOAT(GL_POLYGON_OFFSET_FACTOR, raster.offset_factor),
    FLOAT(GL_POLYGON_OFFSET_UNITS, raster.offset_units),

    /* Textures */
    PER_UNIT(GL_TEXTURE_1D, STATE_SWITCH, 1, unit[0].enabled[TARGET_1D], sizeof(texture_unit)),
    PER_UNIT(GL_TEXTURE_2D, STATE_SWITCH, 1, unit[0].enabled[TARGET_2D], sizeof(texture_unit)),
    PER_UNIT(GL_TEXTURE_3D, STATE_SWITCH, 1, unit[0].enabled[TARGET_3D], sizeof(texture_unit)),
    PER_UNIT(GL_TEXTURE_CUBE_MAP, STATE_SWITCH, 1, unit[0].enabled[TARGET_CUBE],
             sizeof(texture_unit)),
    SWITCH(GL_TEXTURE_CUBE_MAP_SEAMLESS, seamless_cubes),
    PER_UNIT(GL_TEXTURE_GEN_S, STATE_SWITCH, 1, unit[0].generation[0].enabled,
             sizeof(texture_unit)),
    PER_UNIT(GL_TEXTURE_GEN_T, STATE_SWITCH, 1, unit[0].generation[1].enabled,
             sizeof(texture_unit)),
    PER_UNIT(GL_TEXTURE_GEN_R, STATE_SWITCH, 1, unit[0].generation[2].enabled,
             sizeof(texture_unit)),
    PER_UNIT(GL_TEXTURE_GEN_Q, STATE_SWITCH, 1, unit[0].generation[3].enabled,
             sizeof(texture_unit)),
    COMPUTED(GL_TEXTURE_BINDING_1D, 1, computed_texture_binding_1d),
    COMPUTED(GL_TEXTURE_BINDING_2D, 1, computed_texture_binding_2d),
    COMPUTED(GL_TEXTURE_BINDING_3D, 1, computed_texture_binding_3d),
    COMPUTED(GL_TEXTURE_BINDING_CUBE_MAP, 1, computed_texture_binding_cube),
    CONSTANT(GL_MAX_TEXTURE_SIZE, 16384),
    COMPUTED_FLOAT(GL_MAX_TEXTURE_LOD_BIAS, 1, computed_most_lod_bias),
    CONSTANT(GL_NUM_COMPRESSED_TEXTURE_FORMATS, 0),
    {GL_COMPRESSED_TEXTURE_FORMATS, STATE_CONSTANT, 0, 0, NULL, 0, false},
    CONSTANT(GL_MAX_3D_TEXTURE_SIZE, 2048),
    CONSTANT(GL_MAX_CUBE_MAP_TEXTURE_SIZE, 16384),

    /* Fragments */
    SWITCH(GL_COLOR_SUM, lighting.color_sum),
    SWITCH(GL_FOG, fog.enabled),
    UNSIGNED(GL_FOG_MODE, fog.mode),
    FLOAT(GL_FOG_DENSITY, fog.density),
    FLOAT(GL_FOG_START, fog.start),
    FLOAT(GL_FOG_END, fog.end),
    FLOAT(GL_FOG_INDEX, fog.index),
    ROW(GL_FOG_COLOR, STATE_CLAMPED, 4, fog.color),
    UNSIGNED(GL_FOG_COORDINATE_SOURCE, fog.coordinate_source),
    SWITCH(GL_SCISSOR_TEST, fragment.scissor),
    ROW(GL_SCISSOR_BOX, STATE_INTEGER, 4, fragment.scissor_box),
    SWITCH(GL_ALPHA_TEST, fragment.alpha_test),
    UNSIGNED(GL_ALPHA_TEST_FUNC, fragment.alpha_function),
    ROW(GL_ALPHA_TEST_REF, STATE_CLAMPED, 1, fragment.alpha_reference),
    SWITCH(GL_STENCIL_TEST, fragment.stencil_test),
    UNSIGNED(GL_STENCIL_FUNC, fragment.stencil[0].function),
    STENCIL(GL_STENCIL_REF, fragment.stencil[0].reference),
    UNSIGNED(GL_STENCIL_VALUE_MASK, fragment.stencil[0].compare_mask),
    UNSIGNED(GL_STENCIL_FAIL, fragment.stencil[0].fail),
    UNSIGNED(GL_STENCIL_PASS_DEPTH_FAIL, fragment.stencil[0].depth_fail),
    UNSIGNED(GL_STENCIL_PASS_DEPTH_PASS, fragment.stencil[0].pass),
    UNSIGNED(GL_STENCIL_WRITEMASK, fragment.stencil[0].write_mask),
    UNSIGNED(GL_STENCIL_BACK_FUNC, fragment.stencil[1].function),
    STENCIL(GL_STENCIL_BACK_REF, fragment.stencil[1].reference),
    UNSIGNED(GL_STENCIL_BACK_VALUE_MASK, fragment.stencil[1].compare_mask),
    UNSIGNED(GL_STENCIL_BACK_FAIL, fragment.stencil[1].fail),
    UNSIGNED(GL_STENCIL_BACK_PASS_DEPTH_FAIL, fragment.stencil[1].depth_fail),
    UNSIGNED(GL_STENCIL_BACK_PASS_DEPTH_PASS, fragment.stencil[1].pass),
    UNSIGNED(GL_STENCIL_BACK_WRITEMASK, fragment.stencil[1].write_mask),
    SWITCH(GL_DEPTH_TEST, fragment.depth_test),
    UNSIGNED(GL_DEPTH_FUNC, fragment.depth_function),
    BOOLEAN(GL_DEPTH_WRITEMASK, fragment.depth_mask),
    SWITCH(GL_BLEND, fragment.blend),
    UNSIGNED(GL_BLEND_SRC, fragment.blend_source),
    UNSIGNED(GL_BLEND_DST, fragment.blend_destination),
    UNSIGNED(GL_BLEND_SRC_RGB, fragment.blend_source),
    UNSIGNED(GL_BLEND_DST_RGB, fragment.blend_destination),
    UNSIGNED(GL_BLEND_SRC_ALPHA, fragment.blend_alpha_source),
    UNSIGNED(GL_BLEND_DST_ALPHA, fragment.blend_alpha_destination),
    UNSIGNED(GL_BLEND_EQUATION, fragment.blend_equation),
    UNSIGNED(GL_BLEND_EQUATION_ALPHA, fragment.blend_alpha_equation),
    ROW(GL_BLEND_COLOR, STATE_CLAMPED, 4, fragment.blend_color),
    SWITCH(GL_DITHER, fragment.dither),
    SWITCH(GL_COLOR_LOGIC_OP, fragment.logic_operation),
    SWITCH(GL_INDEX_LOGIC_OP, fragment.index_logic_operation),
    UNSIGNED(GL_LOGIC_OP_MODE, fragment.logic_function),
    SWITCH(GL_MULTISAMPLE, fragment.multisample),
    SWITCH(GL_SAMPLE_ALPHA_TO_COVERAGE, fragment.alpha_to_coverage),
    SWITCH(GL_SAMPLE_ALPHA_TO_ONE, fragment.alpha_to_one),
    SWITCH(GL_SAMPLE_COVERAGE, fragment.sample_coverage),
    FLOAT(GL_SAMPLE_COVERAGE_VALUE, fragment.sample_coverage_value),
    BOOLEAN(GL_SAMPLE_COVERAGE_INVERT, fragment.sample_coverage_invert),
    ROW(GL_COLOR_WRITEMASK, STATE_BOOLEAN, 4, fragment.color_mask),
    INTEGER(GL_INDEX_WRITEMASK, fragment.index_mask),
    ROW(GL_COLOR_CLEAR_VALUE, STATE_CLAMPED, 4, fragment.clear_color),
    ROW(GL_DEPTH_CLEAR_VALUE, STATE_DOUBLE, 1, fragment.clear_depth),
    INTEGER(GL_STENCIL_CLEAR_VALUE, fragment.clear_stencil),
    ROW(GL_ACCUM_CLEAR_VALUE, STATE_FRACTION, 4, fragment.clear_accumulation),
    INTEGER(GL_INDEX_CLEAR_VALUE, fragment.clear_index),
    COMPUTED(GL_DRAW_BUFFER, 1, computed_draw_buffer),
    COMPUTED(GL_READ_BUFFER, 1, computed_read_buffer),
    SWITCH(GL_FRAMEBUFFER_SRGB, fragment.framebuffer_srgb),
    COMPUTED(GL_DRAW_FRAMEBUFFER_BINDING, 1, computed_draw_framebuffer),
    COMPUTED(GL_READ_FRAMEBUFFER_BINDING, 1, computed_read_framebuffer),
    COMPUTED(GL_RENDERBUFFER_BINDING, 1, computed_bound_renderbuffer),

    /* Arrays */
    CLIENT_SWITCH(GL_VERTEX_ARRAY, ARRAY(VERTEX_ARRAY).enabled),
    INTEGER(GL_VERTEX_ARRAY_SIZE, ARRAY(VERTEX_ARRAY).size),
    UNSIGNED(GL_VERTEX_ARRAY_TYPE, ARRAY(VERTEX_ARRAY).type),
    INTEGER(GL_VERTEX_ARRAY_STRIDE, ARRAY(VERTEX_ARRAY).stride),
    INTEGER(GL_VERTEX_ARRAY_BUFFER_BINDING, ARRAY(VERTEX_ARRAY).buffer_name),
    CLIENT_SWITCH(GL_NORMAL_ARRAY, ARRAY(NORMAL_ARRAY).enabled),
    UNSIGNED(GL_NORMAL_ARRAY_TYPE, ARRAY(NORMAL_ARRAY).type),
    INTEGER(GL_NORMAL_ARRAY_STRIDE, ARRAY(NORMAL_ARRAY).stride),
    INTEGER(GL_NORMAL_ARRAY_BUFFER_BINDING, ARRAY(NORMAL_ARRAY).buffer_name),
    CLIENT_SWITCH(GL_COLOR_ARRAY, ARRAY(COLOR_ARRAY).enabled),
    INTEGER(GL_COLOR_ARRAY_SIZE, ARRAY(COLOR_ARRAY).size),
    UNSIGNED(GL_COLOR_ARRAY_TYPE, ARRAY(COLOR_ARRAY).type),
    INTEGER(GL_COLOR_ARRAY_STRIDE, ARRAY(COLOR_ARRAY).stride),
    INTEGER(GL_COLOR_ARRAY_BUFFER_BINDING, ARRAY(COLOR_ARRAY).buffer_name),
    CLIENT_SWITCH(GL_SECONDARY_COLOR_ARRAY, ARRAY(SECONDARY_COLOR_ARRAY).enabled),
    INTEGER(GL_SECONDARY_COLOR_ARRAY_SIZE, ARRAY(SECONDARY_COLOR_ARRAY).size),
    UNSIGNED(GL_SECONDARY_COLOR_ARRAY_TYPE, ARRAY(SECONDARY_COLOR_ARRAY).type),
    INTEGER(GL_SECONDARY_COLOR_ARRAY_STRIDE, ARRAY(SECONDARY_COLOR_ARRAY).stride),
    INTEGER(GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, ARRAY(SECONDARY_COLOR_ARRAY).buffer_name),
    CLIENT_SWITCH(GL_FOG_COORDINATE_ARRAY, ARRAY(FOG_COORDINATE_ARRAY).enabled),
    UNSIGNED(GL_FOG_COORDINATE_ARRAY_TYPE, ARRAY(FOG_COORDINATE_ARRAY).type),
    INTEGER(GL_FOG_COORDINATE_ARRAY_STRIDE, ARRAY(FOG_COORDINATE_ARRAY).stride),
    INTEGER(GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING, ARRAY(FOG_COORDINATE_ARRAY).buffer_name),
    CLIENT_SWITCH(GL_EDGE_FLAG_ARRAY, ARRAY(EDGE_FLAG_ARRAY).enabled),
    INTEGER(GL_EDGE_FLAG_ARRAY_STRIDE, ARRAY(EDGE_FLAG_ARRAY).stride),
    INTEGER(GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, ARRAY(EDGE_FLAG_ARRAY).buffer_name),
    CLIENT_SWITCH(GL_INDEX_ARRAY, ARRAY(INDEX_ARRAY).enabled),
    UNSIGNED(GL_INDEX_ARRAY_TYPE, ARRAY(INDEX_ARRAY).type),
    INTEGER(GL_INDEX_ARRAY_STRIDE, ARRAY(INDEX_ARRAY).stride),
    INTEGER(GL_INDEX_ARRAY_BUFFER_BINDING, ARRAY(INDEX_ARRAY).buffer_name),
    COORDINATE_ARRAY(GL_TEXTURE_COORD_ARRAY, STATE_CLIENT_SWITCH, enabled),
    COORDINATE_ARRAY(GL_TEXTURE_COORD_ARRAY_SIZE, STATE_INTEGER, size),
    COORDINATE_ARRAY(GL_TEXTURE_COORD_ARRAY_TYPE, STATE_UNSIGNED, type),
    COORDINATE_ARRAY(GL_TEXTURE_COORD_ARRAY_STRIDE, STATE_INTEGER, stride),
    COORDINATE_ARRAY(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, STATE_INTEGER, buffer_name),
    INTEGER(GL_ARRAY_BUFFER_BINDING, arrays.array_buffer_name),
    INTEGER(GL_ELEMENT_ARRAY_BUFFER_BINDING, arrays.element_buffer_name),
    INTEGER(GL_PIXEL_PACK_BUFFER_BINDING, arrays.pack_buffer_name),
    INTEGER(GL_PIXEL_UNPACK_BUFFER_BINDING, arrays.unpack_buffer_name),
    COMPUTED(GL_ACTIVE_TEXTURE, 1, computed_active_texture),
    COMPUTED(GL_CLIENT_ACTIVE_TEXTURE, 1, computed_client_active_texture),

    /* Pixels in the program's memory */
    FLOAT(GL_ZOOM_X, pixel_zoom[0]),
    FLOAT(GL_ZOOM_Y, pixel_zoom[1]),
    BOOLEAN(GL_MAP_COLOR, transfer.map_color),
    BOOLEAN(GL_MAP_STENCIL, transfer.map_stencil),
    INTEGER(GL_INDEX_SHIFT, transfer.index_shift),
    INTEGER(GL_INDEX_OFFSET, transfer.index_offset),
    FLOAT(GL_RED_SCALE, transfer.scale[0]),
    FLOAT(GL_RED_BIAS, transfer.bias[0]),
    FLOAT(GL_GREEN_SCALE, transfer.scale[1]),
    FLOAT(GL_GREEN_BIAS, transfer.bias[1]),
    FLOAT(GL_BLUE_SCALE, transfer.scale[2]),
    FLOAT(GL_BLUE_BIAS, transfer.bias[2]),
    FLOAT(GL_ALPHA_SCALE, transfer.scale[3]),
    FLOAT(GL_ALPHA_BIAS, transfer.bias[3]),
    FLOAT(GL_DEPTH_SCALE, transfer.depth_scale),
    FLOAT(GL_DEPTH_BIAS, transfer.depth_bias),
    INTEGER(GL_PIXEL_MAP_I_TO_I_SIZE, map[MAP_I_TO_I].size),
    INTEGER(GL_PIXEL_MAP_S_TO_S_SIZE, map[MAP_S_TO_S].size),
    INTEGER(GL_PIXEL_MAP_I_TO_R_SIZE, map[MAP_I_TO_R].size),
    INTEGER(GL_PIXEL_MAP_I_TO_G_SIZE, map[MAP_I_TO_G].size),
    INTEGER(GL_PIXEL_MAP_I_TO_B_SIZE, map[MAP_I_TO_B].size),
    INTEGER(GL_PIXEL_MAP_I_TO_A_SIZE, map[MAP_I_TO_A].size),
    INTEGER(GL_PIXEL_MAP_R_TO_R_SIZE, map[MAP_R_TO_R].size),
    INTEGER(GL_PIXEL_MAP_G_TO_G_SIZE, map[MAP_G_TO_G].size),
    INTEGER(GL_PIXEL_MAP_B_TO_B_SIZE, map[MAP_B_TO_B].size),
    INTEGER(GL_PIXEL_MAP_A_TO_A_SIZE, map[MAP_A_TO_A].size),
    CONSTANT(GL_MAX_PIXEL_MAP_TABLE, PIXEL_MAP_SIZE),
    BOOLEAN(GL_PACK_SWAP_BYTES, pack.swap_bytes),
    BOOLEAN(GL_PACK_LSB_FIRST, pack.lsb_first),
    INTEGER(GL_PACK_IMAGE_HEIGHT, pack.image_height),
    INTEGER(GL_PACK_SKIP_IMAGES, pack.skip_images),
    INTEGER(GL_PACK_ROW_LENGTH, pack.row_length),
    INTEGER(GL_PACK_SKIP_ROWS, pack.skip_rows),
    INTEGER(GL_PACK_SKIP_PIXELS, pack.skip_pixels),
    INTEGER(GL_PACK_ALIGNMENT, pack.alignment),
    BOOLEAN(GL_UNPACK_SWAP_BYTES, unpack.swap_bytes),
    BOOLEAN(GL_UNPACK_LSB_FIRST, unpack.lsb_first),
    INTEGER(GL_UNPACK_IMAGE_HEIGHT, unpack.image_height),
    INTEGER(GL_UNPACK_SKIP_IMAGES, unpack.skip_images),
    INTEGER(GL_UNPACK_ROW_LENGTH, unpack.row_length),
    INTEGER(GL_UNPACK_SKIP_ROWS, unpack.skip_rows),
    INTEGER(GL_UNPACK_SKIP_PIXELS, unpack.skip_pixels),
    INTEGER(GL_UNPACK_ALIGNMENT, unpack.alignment),

    /* Evaluators */
    SWITCH(GL_AUTO_NORMAL, evaluator.auto_normal),
    EVALUATOR(GL_MAP1_COLOR_4, GL_MAP2_COLOR_4, MAP_COLOR_4),
    EVALUATOR(GL_MAP1_INDEX, GL_MAP2_INDEX, MAP_INDEX),
    EVALUATOR(GL_MAP1_NORMAL, GL_MAP2_NORMAL, MAP_NORMAL),
    EVALUATOR(GL_MAP1_TEXTURE_COORD_1, GL_MAP2_TEXTURE_COORD_1, MAP_COORDINATE_1),
    EVALUATOR(GL_MAP1_TEXTURE_COORD_2, GL_MAP2_TEXTURE_COORD_2, MAP_COORDINATE_1 + 1),
    EVALUATOR(GL_MAP1_TEXTURE_COORD_3, GL_MAP2_TEXTURE_COORD_3, MAP_COORDINATE_1 + 2),
    EVALUATOR(GL_MAP1_TEXTURE_COORD_4, GL_MAP2_TEXTURE_COORD_4, MAP_COORDINATE_1 + 3),
    EVALUATOR(GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, MAP_VERTEX_3),
    EVALUATOR(GL_MAP1_VERTEX_4, GL_MAP2_VERTEX_4, MAP_VERTEX_4),
    INTEGER(GL_MAP1_GRID_SEGMENTS, evaluator.segments1),
    ROW(GL_MAP1_GRID_DOMAIN, STATE_FLOAT, 2, evaluator.domain1),
    ROW(GL_MAP2_GRID_SEGMENTS, STATE_INTEGER, 2, evaluator.segments2),
    ROW(GL_MAP2_GRID_DOMAIN, STATE_FLOAT, 4, evaluator.domain2),
    CONSTANT(GL_MAX_EVAL_ORDER, MOST_ORDER),

    /* Stacks of attributes */
    INTEGER(GL_ATTRIB_STACK_DEPTH, stacks.depth),
    INTEGER(GL_CLIENT_ATTRIB_STACK_DEPTH, stacks.client_depth),
    CONSTANT(GL_MAX_ATTRIB_STACK_DEPTH, ATTRIBUTE_DEPTH),
    CONSTANT(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, ATTRIBUTE_DEPTH),

    /* Display lists */
    UNSIGNED(GL_LIST_BASE, list.base),
    UNSIGNED(GL_LIST_INDEX, list.name),
    UNSIGNED(GL_LIST_MODE, list.mode),
    CONSTANT(GL_MAX_LIST_NESTING, LIST_NESTING),

    /* Selection and feedback */
    UNSIGNED(GL_RENDER_MODE, render_mode),
    INTEGER(GL_SELECTION_BUFFER_SIZE, selection.size),
    INTEGER(GL_NAME_STACK_DEPTH, selection.depth),
    CONSTANT(GL_MAX_NAME_STACK_DEPTH, NAME_STACK_DEPTH),
    INTEGER(GL_FEEDBACK_BUFFER_SIZE, feedback.size),
    UNSIGNED(GL_FEEDBACK_BUFFER_TYPE, feedback.type),

    /* Hints */
    UNSIGNED(GL_PERSPECTIVE_CORRECTION_HINT, hint.perspective),
    UNSIGNED(GL_POINT_SMOOTH_HINT, hint.point),
    UNSIGNED(GL_LINE_SMOOTH_HINT, hint.line),
    UNSIGNED(GL_POLYGON_SMOOTH_HINT, hint.polygon),
    UNSIGNED(GL_FOG_HINT, hint.fog),
    UNSIGNED(GL_GENERATE_MIPMAP_HINT, hint.mipmap),
    UNSIGNED(GL_TEXTURE_COMPRESSION_HINT, hint.compression),

    /* The window */
    COMPUTED(GL_RED_BITS, 1, computed_red_bits),
    COMPUTED(GL_GREEN_BITS, 1, computed_green_bits),
    COMPUTED(GL_BLUE_BITS, 1, computed_blue_bits),
    COMPUTED(GL_ALPHA_BITS, 1, computed_alpha_bits),
    CONSTANT(GL_INDEX_BITS, 0),
    COMPUTED(GL_DEPTH_BITS, 1, computed_depth_bits),
    COMPUTED(GL_STENCIL_BITS, 1, computed_stencil_bits),
    COMPUTED(GL_ACCUM_RED_BITS, 1, computed_bits_of_accumulation),
    COMPUTED(GL_ACCUM_GREEN_BITS, 1, computed_bits_of_accumulation),
    COMPUTED(GL_ACCUM_BLUE_BITS, 1, computed_bits_of_accumulation),
    COMPUTED(GL_ACCUM_ALPHA_BITS, 1, computed_bits_of_accumulation),
    CONSTANT(GL_VERTEX_ARRAY_COUNT_EXT, 0),
    CONSTANT(GL_NORMAL_ARRAY_COUNT_EXT, 0),
    CONSTANT(GL_COLOR_ARRAY_COUNT_EXT, 0),
    CONSTANT(GL_INDEX_ARRAY_COUNT_EXT, 0),
    CONSTANT(GL_TEXTURE_COORD_ARRAY_COUNT_EXT, 0),
    CONSTANT(GL_EDGE_FLAG_ARRAY_COUNT_EXT, 0),
    CONSTANT(GL_AUX_BUFFERS, 0),
    CONSTANT(GL_RGBA_MODE, 1),
    CONSTANT(GL_INDEX_MODE, 0),
    CONSTANT(GL_DOUBLEBUFFER, 0),
    CONSTANT(GL_STEREO, 0),
    COMPUTED(GL_FRAMEBUFFER_SRGB_CAPABLE_EXT, 1, computed_is_srgb),
    INTEGER(GL_DEBUG_GROUP_STACK_DEPTH, debug_groups),
    CONSTANT(GL_MAX_DEBUG_GROUP_STACK_DEPTH, DEBUG_GROUPS),
    SWITCH(GL_DEBUG_OUTPUT, debug_output),
    SWITCH(GL_DEBUG_OUTPUT_SYNCHRONOUS, debug_is_synchronous),
    CONSTANT(GL_MAX_DEBUG_MESSAGE_LENGTH, 4096),
    CONSTANT(GL_MAX_DEBUG_LOGGED_MESSAGES, 10),
    CONSTANT(GL_DEBUG_LOGGED_MESSAGES, 0),
    CONSTANT(GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH, 0),
    CONSTANT(GL_MAX_LABEL_LENGTH, LABEL_SIZE),
    COMPUTED(GL_SAMPLE_BUFFERS, 1, computed_sample_buffers),
    COMPUTED(GL_SAMPLES, 1, computed_samples),
    COMPUTED(GL_IMPLEMENTATION_COLOR_READ_FORMAT, 1, computed_read_format),
    CONSTANT(GL_IMPLEMENTATION_COLOR_READ_TYPE, GL_UNSIGNED_BYTE),

    /* Limits */
    {GL_MAX_VIEWPORT_DIMS, STATE_CONSTANT, 2, 16384, NULL, 0, false},
    CONSTANT(GL_SUBPIXEL_BITS, 8),
    CONSTANT(GL_MAX_RENDERBUFFER_SIZE, GN_MAX_SIZE),
    CONSTANT(GL_MAX_COLOR_ATTACHMENTS, GN_MAX_COLORS),
    CONSTANT(GL_MAX_DRAW_BUFFERS, GN_MAX_COLORS),
    CONSTANT(GL_MAX_SAMPLES, GN_SAMPLES),
    CONSTANT(GL_MAX_ELEMENTS_VERTICES, 3000),
    CONSTANT(GL_MAX_ELEMENTS_INDICES, 3000),
    CONSTANT(GL_MAX_TEXTURE_UNITS, TEXTURE_UNITS),
    CONSTANT(GL_MAX_LIGHTS, LIGHTS),
};

const state_row *find_state(GLenum name)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i)
        if (rows[i].name == name)
            return &rows[i];
    return NULL;
}

size_t state_offset(const context *gl, const state_row *row)
{
    const GLint unit = row->steps_by_client ? gl->arrays.client_texture : gl->active_texture;

    return row->offset + (size_t)unit * row->step;
}

static bool is_saved_switch(const state_row *row)
{
    return row->kind == STATE_SWITCH && !(row->name >= GL_LIGHT0 && row->name <= GL_LIGHT7) &&
           row->name != GL_COLOR_SUM && row->name != GL_TEXTURE_CUBE_MAP_SEAMLESS;
}

size_t switch_places(context *gl, GLboolean *place[MOST_SWITCHES])
{
    size_t count = 0;

    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i)
        for (size_t u = 0; is_saved_switch(&rows[i]) && u < (rows[i].step ? TEXTURE_UNITS : 1); ++u)
            place[count++] = (GLboolean *)gl + rows[i].offset + u * rows[i].step;
    return count;
}

GLboolean *find_switch(context *gl, GLenum name, state_kind kind)
{
    const state_row *const row = find_state(name);

    return row && row->kind == kind ? (GLboolean *)gl + state_offset(gl, row) : NULL;
}
