/* All pixel formats (src/formats/format_table.h). */
#ifndef UNIT_FORMATS_H
#define UNIT_FORMATS_H

#include <stdbool.h>

#include "../../src/formats/format_table.h"
#include "unit.h"

static const struct format {
    gn_format format;
    uint32_t size, element; /* bytes of a pixel; what it is aligned to */
    bool is_color;
} formats[] = {
#define IS_COLOR true
#define IS_DEPTH false
#define ROW(name, layout, kind, ...)                                                               \
    {GN_FORMAT_##name, LAYOUT_##layout##_BYTES, LAYOUT_##layout##_ELEMENT, IS_##kind},
    GN_FORMATS(ROW)};

#endif
