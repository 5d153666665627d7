// Settings of the compiler that work on all bodies of a document. MuJoCo has them for whole documents only; so where
// documents are put together, each is first weighed by its own.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "document/limits.h"

namespace mimo::document {

// Gives every body the mass and inertia that the compiler gives it, and takes those settings out of the document: to
// what is put beside it they do nothing. A document without them stays as it is. Throws Status::kUnsupported, naming
// `what`, where bodies are made by the compiler itself, and Status::kModel for a document that does not compile.
void weigh_alone(pugi::xml_document& document, const std::string& what, const Limits& limits);

}  // namespace mimo::document
