// Numbers in attributes as far as they can be read; what cannot be read is left to the compiler, which says so.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace mimo::document {

// The first number of an attribute; nothing if it is not there or begins with something else.
std::optional<double> number(pugi::xml_node node, const char* attribute);
// All up to the first that is none.
std::vector<double> numbers_in(pugi::xml_node node, const char* attribute);
// How many words an attribute has.
std::size_t words(pugi::xml_attribute attribute);

// Reads a number out of a text and moves on past it; nothing if there is none.
std::optional<double> take_number(const char*& at, const char* end);

}  // namespace mimo::document
