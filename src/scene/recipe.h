// What a room does with an infant that is put into it: where it lies or stands, how it is held, what of it acts.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/log.h"
#include "document/attributes.h"
#include "document/library.h"
#include "engine/physics.h"

namespace mimo::scene {

// What a room does with an infant that is put into it: how it is held, what of it acts, what stands around it. A room
// names its recipe by a custom text, "mimo:infant"; the recipe is an MJCF file whose names get the infant's prefix.

class Recipe {
 public:
  // The recipe of a room; an empty one if the room has none.
  static Recipe of_room(pugi::xml_node room, const document::Library& library);

  // Groups whose motors act; all of them if the recipe does not say.
  unsigned acts() const;
  // How the names of motors begin that do not act although their group does, "right_thumb_".
  std::vector<std::string> still() const;
  // The senses that an infant has, by their names; none if the recipe does not say.
  std::vector<std::string> senses() const;
  // Whether the infant acts with muscles; else with motors.
  bool muscles() const;
  // Bodies that it is made for, the usual one first; none if it does for all.
  std::vector<std::string> bodies() const;
  // Puts its content into the document that holds the infant, except what concerns parts that the infant does not
  // have: one recipe does for several bodies. With `keep_root` the infant stays where it was put.
  void apply(pugi::xml_node root, const std::string& prefix, bool keep_root);

 private:
  pugi::xml_document document_;
};

// A custom text of a document; "" if there is none.
std::string custom_text(pugi::xml_node root, const std::string& name);
std::vector<std::string> custom_words(pugi::xml_node root, const std::string& name);
// A custom number of a document as the model will have it; empty if there is none.
std::vector<double> custom_numbers(pugi::xml_node root, const std::string& name);

// Takes the infant's motors of all groups but these out of the document, and those whose names begin with one of
// `still`.
void keep_motors(pugi::xml_node root, const std::string& prefix, unsigned groups,
                 const std::vector<std::string>& still = {});

// Where an infant without a given place is put, and the warning about an infant whose place is taken.

// Everything where the model starts.
engine::Physics at_start(const engine::ModelPtr& model);

// A pose in which the infant is inside of nothing: upright on what stands still below or above the origin, on the
// surface nearest to the origin's height; where something stands there already, beside it. Without such a pose, and
// where there is no ground, the origin.
document::Pose free_spot(engine::Physics& physics, const std::string& prefix);

// Where the root of an infant has to be for its anchor to lie at the place; it has the place's orientation already.
document::Pose root_of(const engine::Physics& physics, const std::string& prefix, const document::Place& place);

// A warning for an infant that starts inside of something, with how deep and in what.
void warn_of_overlap(const engine::Physics& physics, const std::string& prefix, const LogSink& log);

}  // namespace mimo::scene
