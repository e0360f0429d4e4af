/* Reads obj. */
#include "read.h"

bool read_obj(model_reader *r)
{
    return reader_fail(r, "is not read yet");
}
