/* The orientation that a camera writes into a JPEG or PNG (Exif 2.32, section 4.6.4: tag 0x0112).
 * It says how a viewer turns the picture. Texture coordinates refer to the picture as it is stored:
 * glTF 2.0, section 2.6, allows to ignore Exif data, and MTL files have no word for it. So the
 * command never turns a picture. */
#ifndef IMAGE_EXIF_H
#define IMAGE_EXIF_H

#include <stddef.h>
#include <stdint.h>

/* Returns the orientation, 1 to 8; 1, as it is stored, if the bytes are neither JPEG nor PNG or
 * name none. */
uint32_t image_exif_orientation(const uint8_t *bytes, size_t size);

#endif
