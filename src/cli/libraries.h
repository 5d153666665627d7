// Shared libraries at run time, as the system has them.
#pragma once

#include <string>

namespace cli {

// Null when there is none of that name.
void* open_library(const char* name);
void* find_symbol(void* library, const char* name);

// Path of the library that holds an address; "" when that cannot be told.
std::string library_of(const void* inside);

}  // namespace cli
