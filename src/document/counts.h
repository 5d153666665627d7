// How many of everything a document has, and what that makes of a model's bytes and of a world's buffers.
#pragma once

#include <pugixml.hpp>
#include <vector>

#include "document/budget.h"
#include "document/limits.h"

namespace mimo::document {

// How many bodies a composite, or another element with a count, becomes.
double made_by(pugi::xml_node element);

class Counts {
 public:
  explicit Counts(const Limits& limits) : limits_(limits) {}

  void add(pugi::xml_node node);

  // Both throw Status::kModel for more than the limits allow, and add to the budget; the second, of a world's buffers,
  // once the budget knows the whole model.
  void check(pugi::xml_node root, Budget& budget) const;
  void check_world(pugi::xml_node root, Budget& budget) const;

 private:
  double size(const char* name, double otherwise) const;
  double model_bytes() const;
  double key_bytes() const;
  double lengths_seconds(pugi::xml_node root) const;
  void add_made(pugi::xml_node node, double made);
  void add_degrees(pugi::xml_node node, double copies);

  const Limits& limits_;
  double elements_ = 0, degrees_ = 0, chains_ = 0, keyframes_ = 0, actuators_ = 0, tendons_ = 0, mocaps_ = 0;
  double text_bytes_ = 0, name_bytes_ = 0, longest_user_ = 0, numeric_ = 0, sensed_ = 0;
  bool dense_ = false;
  std::vector<pugi::xml_node> sizes_, moved_;
  pugi::xml_node most_at_, last_key_, lengths_;
};

}  // namespace mimo::document
