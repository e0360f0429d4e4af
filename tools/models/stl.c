/* Reads stl. */
#include "read.h"

bool read_stl(model_reader *r)
{
    return reader_fail(r, "is not read yet");
}
