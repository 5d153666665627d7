// A scene on disk, for whoever has MuJoCo but not libmimo.
#pragma once

#include <pugixml.hpp>
#include <string>

namespace mimo::document {

// Writes FOLDER/scene.xml and copies of all files that it refers to, FOLDER/assets/..., under plain names. Makes the
// folder where it is not there. Throws Status::kFile for a file that is there with other content, or that cannot be
// written, and kNotFound for one that cannot be read; nothing has been written then. A process that is killed leaves
// whole files, scene.xml last.
void save(const pugi::xml_document& document, const std::string& folder);

}  // namespace mimo::document
