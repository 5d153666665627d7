// A scene on disk, for whoever has MuJoCo but not libmimo.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "document/limits.h"

namespace mimo::document {

// A document and all that it refers to: "assets/floor.png".
struct Package {
  std::string document;
  Files files;

  std::size_t bytes() const;
};
// Files are those of the limits, if they hold any, else on disk. Throws Status::kNotFound for one that cannot be read.
Package package(const pugi::xml_document& document, const Limits& limits);

// Writes FOLDER/scene.xml and copies of all files that it refers to, FOLDER/assets/..., under plain names. Makes the
// folder where it is not there. Throws Status::kFile for a file that is there with other content, or that cannot be
// written; nothing has been written then. A process that is killed leaves
// whole files, scene.xml last.
void save(const Package& package, const std::string& folder);

}  // namespace mimo::document
