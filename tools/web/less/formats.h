/* The stages for fewer formats: the only ones of the page's pictures and shadows are RGBA8 and
 * D32F. Before the text of the stages. */
#ifndef LESS_FORMATS_H
#define LESS_FORMATS_H

#include "../../../src/formats/properties.h"

#define format_is_compiled(format) ((format) == GN_FORMAT_RGBA8 || (format) == GN_FORMAT_D32F)
#define arithmetic_of(format) ((void)(format), ARITHMETIC_BYTES)

#endif
