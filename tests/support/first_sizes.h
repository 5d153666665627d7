/* The sizes that structs had at first, as enumerators such as mimo_field_first. They may have grown. */
#ifndef MIMO_TESTS_FIRST_SIZES_H
#define MIMO_TESTS_FIRST_SIZES_H

#include <mimo/mimo.h>

#define MIMO_FIRST_SIZE(type, bytes) enum { type##_first = (bytes) }
#include "capi/first_sizes.h"
#undef MIMO_FIRST_SIZE

#endif
