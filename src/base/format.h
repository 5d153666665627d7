// All of fmt (join, format), compiled into the files that include this: libmimo.so needs no libfmt.
#pragma once

#ifndef FMT_HEADER_ONLY
#define FMT_HEADER_ONLY
#endif
#include <fmt/format.h>
