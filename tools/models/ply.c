/* Reads ply. */
#include "read.h"

bool read_ply(model_reader *r)
{
    return reader_fail(r, "is not read yet");
}
