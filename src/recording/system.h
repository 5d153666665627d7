// What recordings need of the operating system.
#pragma once

#include <string>

namespace mimo::recording {

// A library that stays loaded, and what it exports; both null where there is no such thing.
void* open_library(const char* name);
void* symbol_of(void* library, const char* name);
std::string why_not_opened();

// The file that holds the code of this library; "" where that cannot be known.
std::string path_of_this_library();

// From now on what is written to an open file goes nowhere.
void write_to_nowhere(int file);

}  // namespace mimo::recording
