// Bodies that are fastened to each other or to the world.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "document/pose.h"
#include "engine/model.h"

namespace mimo::scene {

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

}  // namespace mimo::scene
