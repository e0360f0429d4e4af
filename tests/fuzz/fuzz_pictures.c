/* Pictures that the command reads: any bytes are an image of the size that the budget allows, or a
 * reason in words. The decoder, stb_image, is the system's and not instrumented; the target is
 * about what the command checks before it, what it makes of the result, and the command's own
 * decoders. */
#include <string.h>

#include "fuzz.h"
#include "image.h"
#include "image_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const uint64_t allowed = (uint64_t)1 << 22;
    image_budget budget = {1, allowed};
    const char *reason = NULL;
    image i;

    const image_kind kind = image_kind_of(bytes, size);

    FUZZ_REQUIRE(kind <= IMAGE_OTHER && image_kind_name(kind));
    if (image_decode(bytes, size, &budget, &i, &reason)) {
        const uint64_t texels = (uint64_t)i.width * i.height;
        uint32_t opaque = UINT32_MAX;

        FUZZ_REQUIRE(i.width >= 1 && i.width <= GN_MAX_SIZE);
        FUZZ_REQUIRE(i.height >= 1 && i.height <= GN_MAX_SIZE);
        FUZZ_REQUIRE(texels <= (1 << 20) && budget.bytes_left + 4 * texels == allowed);
        for (uint64_t t = 0; t < texels; ++t)
            opaque &= i.texels[t] >> 24;
        /* These formats have no alpha, so every texel is opaque. */
        FUZZ_REQUIRE(opaque == 255 || (kind != IMAGE_JPEG && kind != IMAGE_PPM));
        /* So is every texel of a TGA without attribute bits. */
        FUZZ_REQUIRE(opaque == 255 || kind != IMAGE_TGA || (bytes[17] & 15) != 0);
        FUZZ_REQUIRE(i.orientation >= 1 && i.orientation <= 8);
        FUZZ_REQUIRE(i.orientation == 1 || kind == IMAGE_JPEG || kind == IMAGE_PNG);
        image_free(&i);
    } else {
        FUZZ_REQUIRE(reason && *reason && !i.texels);
        FUZZ_REQUIRE(budget.bytes_left == allowed);
    }
    return 0;
}
