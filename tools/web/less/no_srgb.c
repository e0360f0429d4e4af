/* The table that encodes sRGB, empty: no surface of the page has this encoding. */
#include "../../../src/formats/srgb.h"

const int32_t gni_srgb_steps[GN_SRGB_STEPS];
