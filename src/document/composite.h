// One composite as a document describes it.
#pragma once

#include <array>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/span.h"

namespace mimo::document {

struct Composite {
  // Throws Status::kModel for what MuJoCo 2.2 refuses whatever the type is.
  explicit Composite(pugi::xml_node element);

  bool is(std::initializer_list<const char*> types) const;
  // "ropeB3", "clothJ0_2_4": what MuJoCo calls its elements.
  std::string named(const char* kind, std::initializer_list<int> numbers) const;
  // Numbers of an attribute, in place of the first of those that are there.
  void read(pugi::xml_attribute attribute, Span<double> values) const;
  [[noreturn]] void refuse(const std::string& what) const;

  pugi::xml_node node;
  std::string prefix, type;
  std::array<int, 3> count{1, 1, 1};
  int dimensions = 0;
  double spacing = 0;
  std::array<double, 3> offset{};
  pugi::xml_node skin;  // empty where it has none
};

}  // namespace mimo::document
