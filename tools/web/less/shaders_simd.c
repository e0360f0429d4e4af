/* src/shaders/shaders.c with fragment shaders that do nothing: the back end with vectors replaces
 * each by its own form (src/backends/shading.inl), by its address. Their bodies differ, since
 * equal functions may be made one, of one address. */
#pragma clang diagnostic ignored "-Wunused-parameter"
#pragma clang diagnostic ignored "-Wunused-function"

#include "../../../src/kernel/shaders/metallic_roughness.inl"
#include "../../../src/kernel/shaders/unlit.inl"

#define LESS_SHADER(number, output) ((output)->kept = (number))
#define shade_color(u, i, output) LESS_SHADER(1, output)
#define shade_unlit_texture(u, i, output) LESS_SHADER(2, output)
#define shade_lit_texture(u, i, output) LESS_SHADER(3, output)
#define shade_flat(u, i, output) LESS_SHADER(4, output)
#define shade_toon(u, i, output) LESS_SHADER(5, output)
#define shade_phong(u, i, output) LESS_SHADER(6, output)
#define shade_blinn_phong(u, i, output) LESS_SHADER(7, output)
#define shade_normal_color(u, i, output) LESS_SHADER(8, output)
#define shade_depth_color(u, i, output) LESS_SHADER(9, output)
#define shade_metallic_roughness(u, i, output) LESS_SHADER(10, output)
#define shade_vertex_surface(u, i, output) ((output)->position[0][0] = 1.0f)
#define shade_vertex_metallic(u, i, output) ((output)->position[0][0] = 2.0f)

#include "../../../src/shaders/shaders.c"
