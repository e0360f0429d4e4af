/* What glGetFramebufferAttachmentParameteriv returns from both libraries.
 *
 * Not alone: registry.py writes gl_registry.h, which it includes. */
#ifndef OSMESA_COMPARE_ATTACHMENTS_H
#define OSMESA_COMPARE_ATTACHMENTS_H

#include "two_libraries.h"

/* Compares all answers, and prints the first that differs. */
bool are_attachments_equal(const library libraries[LIBRARIES]);

#endif
