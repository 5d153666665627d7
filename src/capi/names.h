// Names of the interface; names.cpp is made of the public headers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace mimo::capi {

// All that this library knows: functions, constants, structs and their members, sorted.
extern const std::string_view kNames[];
extern const std::size_t kNameCount;

const char* name_of(std::int32_t status);

}  // namespace mimo::capi
