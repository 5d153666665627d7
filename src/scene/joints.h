// Joints of a document: where they start and where they are held. Values are radians or metres.
#pragma once

#include <pugixml.hpp>
#include <string>

namespace mimo::scene {

// Both throw Status::kNotFound for a joint that is not there, and kInvalidArgument for one that is no hinge or slide,
// and for a value out of its range.
void start_joint(pugi::xml_node root, const std::string& joint, double value);
// It starts where it is held.
void lock_joint(pugi::xml_node root, const std::string& joint, double value);

}  // namespace mimo::scene
