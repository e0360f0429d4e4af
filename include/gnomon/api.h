/* How the library's symbols are declared: C linkage, and the only visible
 * symbols of a shared library that is otherwise hidden. */
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
