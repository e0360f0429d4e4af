/* Work on rows over the lanes that every processor of the target has. */
#define GN_ROWS gni_rows
#include "../kernel/surfaces/row_work.inl"

void gni_store_color(gn_format format, unsigned char *pixel, const float color[4])
{
    lanes_f lanes[4];

    for (int c = 0; c < 4; ++c)
        lanes[c] = lanes_splat(color[c]);
    store_colors(format, pixel, 1, lanes);
}
