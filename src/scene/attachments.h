// What is attached to a document: another document as one object, welds and other equalities between bodies.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "document/attributes.h"
#include "document/budget.h"
#include "engine/model.h"

namespace mimo::scene {

// An MJCF document that becomes one object of a scene.

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

// Bodies that are fastened to each other or to the world.

struct Weld {
  std::string body;
  std::string other = "world";
};

// Throws Status::kNotFound for a body that is not there.
void require_bodies(pugi::xml_node root, const Weld& weld);

// Fastens the body in a pose in the other's frame.
void add_weld(pugi::xml_node root, const Weld& weld, const document::Pose& pose);

// Fastens bodies as they are to each other where the model, made from the same document, starts.
void add_start_welds(pugi::xml_node root, const std::vector<Weld>& welds, const engine::ModelPtr& model);

// Equalities that calls add to a document.

// A new "joint" or "weld". Spelt out, so that main defaults of a user's document do not change it: it is on, and holds
// as the infant's own do.
pugi::xml_node add_equality(pugi::xml_node root, const char* kind);

}  // namespace mimo::scene
