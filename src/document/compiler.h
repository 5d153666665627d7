// Settings of the compiler by which a document is meant to be read: documents that are put together must agree on them.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "document/budget.h"

namespace mimo::document {

// A setting of the document's compiler elements, "" where they do not say; the last one counts, as in MuJoCo.
std::string compiler_setting(pugi::xml_node root, const char* attribute);

// Whether angles of a document are in radians; MJCF's default is degrees.
bool in_radians(pugi::xml_node root);

// Whether what has a range is limited by that, unless it says otherwise. Newer versions of MuJoCo do so by themselves;
// here a document would be refused that leaves it open, so there is none that means anything else by it.
bool infers_limits(pugi::xml_node root);

// Turns all angles from degrees into radians.
void convert_to_radians(pugi::xml_node root);

// What is added has coordinates of its own: throws Status::kUnsupported for a document with global ones.
void require_local_coordinates(pugi::xml_node root, const std::string& what);

// Changes a document so that under the host's settings it means what it did under its own. Throws Status::kUnsupported,
// naming `what`, where that cannot be.
void adapt(pugi::xml_node guest, pugi::xml_node host, const std::string& what);

// Settings of the compiler that work on all bodies of a document. MuJoCo has them for whole documents only; so where
// documents are put together, each is first weighed by its own.

// Gives every body the mass and inertia that the compiler gives it, and takes those settings out of the document: to
// what is put beside it they do nothing. A document without them stays as it is. Throws Status::kUnsupported, naming
// `what`, where bodies are made by the compiler itself, and Status::kModel for a document that does not compile.
void weigh_alone(pugi::xml_document& document, const std::string& what, const Limits& limits);

}  // namespace mimo::document
