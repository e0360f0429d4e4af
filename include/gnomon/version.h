/** @file
 * The version of the headers, and that of the library that a program is linked with.
 *
 * Versions are semantic (semver.org). A new major version may change pixels, results of the
 * mathematics or the interface; a minor version adds; a patch mends. Within a major version from 1
 * on, programs need not be compiled again. Major version 0 is a preview: its minor versions may
 * change the interface and pixels. */
#ifndef GNOMON_VERSION_H
#define GNOMON_VERSION_H

#include <stdint.h>

#include "api.h"

/** The three numbers of the version. @{ */
#define GN_VERSION_MAJOR 0
#define GN_VERSION_MINOR 1
#define GN_VERSION_PATCH 0
/** @} */

/** One number for `#if GN_VERSION >= GN_VERSION_NUMBER(0, 1, 0)`. Minor version and patch must be
 * below 1000. @{ */
#define GN_VERSION_NUMBER(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
#define GN_VERSION GN_VERSION_NUMBER(GN_VERSION_MAJOR, GN_VERSION_MINOR, GN_VERSION_PATCH)
/** @} */

GN_BEGIN

/** Returns GN_VERSION of the library itself. If it differs from the program's GN_VERSION, a shared
 * library was replaced after the program was compiled. */
GN_API uint32_t gn_version(void);

GN_END

#endif
