/* The colour that shows how two pixels differ. */
#ifndef DIFFERENCE_H
#define DIFFERENCE_H

#include <stdbool.h>
#include <stdint.h>

/* Makes differences visible: even the least difference is a clear grey. */
#define DIFFERENCE_BASE 79
#define DIFFERENCE_STEP 16

/* Writes red, green and blue: black if the pixels are equal, otherwise the amplified differences of
 * the channels of a and b. Magenta if these channels are equal and the pixels differ in something
 * that they do not show, such as alpha or depth. */
static inline void difference_shown(const uint8_t a[3], const uint8_t b[3], bool differs,
                                    uint8_t shown[3])
{
    bool visible = false;
    for (int i = 0; i < 3; ++i) {
        const int difference = a[i] > b[i] ? a[i] - b[i] : b[i] - a[i];
        const int amplified = difference == 0 ? 0 : DIFFERENCE_BASE + DIFFERENCE_STEP * difference;
        shown[i] = (uint8_t)(amplified > 255 ? 255 : amplified);
        visible = visible || difference != 0;
    }
    if (!visible && differs) {
        shown[0] = shown[2] = 255;
        shown[1] = 0;
    }
}

#endif
