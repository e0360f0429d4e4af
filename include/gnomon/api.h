/** @file
 * How the library's symbols are declared: with C linkage, and visible in a shared library whose
 * other symbols are hidden. */
#ifndef GNOMON_API_H
#define GNOMON_API_H

#ifdef __cplusplus
#define GN_BEGIN extern "C" {
#define GN_END }
#else
#define GN_BEGIN
#define GN_END
#endif

#if defined(__GNUC__)
#define GN_API __attribute__((visibility("default")))
#else
#define GN_API
#endif

#endif
