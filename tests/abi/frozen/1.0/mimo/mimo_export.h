/* Symbol visibility of libmimo. MIT licence, see LICENSE. */
#ifndef MIMO_EXPORT_H
#define MIMO_EXPORT_H

#if defined(MIMO_STATIC)
#define MIMO_API
#elif defined(_WIN32) && defined(MIMO_BUILDING)
#define MIMO_API __declspec(dllexport)
#elif defined(_WIN32)
#define MIMO_API __declspec(dllimport)
#elif defined(__GNUC__)
#define MIMO_API __attribute__((visibility("default")))
#else
#define MIMO_API
#endif

/* What a shared library with a sense of your own exports (experimental/sense.h). */
#if defined(_WIN32)
#define MIMO_PLUGIN __declspec(dllexport)
#elif defined(__GNUC__)
#define MIMO_PLUGIN __attribute__((visibility("default")))
#else
#define MIMO_PLUGIN
#endif

/* In C++ every function of the library is noexcept: no exception crosses the border. */
#if defined(__cplusplus)
#define MIMO_NOEXCEPT noexcept
#else
#define MIMO_NOEXCEPT
#endif

#endif
