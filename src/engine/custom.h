// What a document says in its <custom> section: plain MJCF in which it speaks to whoever knows the names.
#pragma once

#include <string>
#include <vector>

#include "base/span.h"
#include "engine/model.h"

namespace mimo::engine {

// "" if there is none of that name.
std::string custom_text(const mjModel& model, const std::string& name);

// Names of all lists of numbers, and of all tuples; "" for those without one.
std::vector<std::string> custom_number_names(const mjModel& model);
std::vector<std::string> custom_tuple_names(const mjModel& model);

// Empty if there is none of that name.
Span<const double> custom_numbers(const mjModel& model, const std::string& name);

struct TupleEntry {
  int id;
  double value;
};

// Entries of a tuple that are of one kind; empty if there is none of that name.
std::vector<TupleEntry> custom_tuple(const mjModel& model, const std::string& name, Kind kind);

}  // namespace mimo::engine
