// What MuJoCo's compiler would believe: sizes, counts and files of a document, checked before it sees them.
#pragma once

#include <pugixml.hpp>

#include "document/budget.h"
#include "document/limits.h"

namespace mimo::document {

// Throws Status::kModel, with file and line, for a document that asks for more than the limits allow, or that would
// make the compiler read or write where it must not. What is wrong in other ways is left to the compiler, which says
// so. Returns what the document will cost.
Budget check(pugi::xml_node root, const Limits& limits);

}  // namespace mimo::document
