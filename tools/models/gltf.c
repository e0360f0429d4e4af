/* Reads glTF. */
#include "read.h"

bool read_gltf(model_reader *r, bool is_binary)
{
    (void)is_binary;
    return reader_fail(r, "is not read yet");
}
