// An MJCF document that becomes one object of a scene.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "document/limits.h"
#include "document/pose.h"

namespace mimo::scene {

struct Model {
  std::string name;
  std::string file, xml;  // just one of them is not empty
  document::Pose pose;
  bool fixed = false;
};

// Makes a document ready to be put into the host's: names with the object's before them, defaults that count for itself
// only, units that are the host's, and its one body at its place. Throws Status::kModel for a document without just one
// body, and what adapt() throws.
void become_object(pugi::xml_document& document, pugi::xml_node host, const Model& model,
                   const document::Limits& limits);

}  // namespace mimo::scene
