// The names of the interface that this library knows, sorted: the build makes the list out of the public headers.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace mimo::capi {

extern const std::string_view kNames[];
extern const std::size_t kNameCount;

}  // namespace mimo::capi
