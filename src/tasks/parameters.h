// Numbers by which tasks can be changed: a name such as "reach/success_reward", a default, a range.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/span.h"

namespace mimo::tasks {

struct Parameter {
  const char* name;
  double standard;   // the default
  double low, high;  // allowed values, both included
  const char* description;
};

// Those of all tasks, one after the other.
std::vector<const Parameter*> parameters();

class Settings {
 public:
  // Throws Status::kNotFound for an unknown name, kInvalidArgument for a value out of range.
  void set(const std::string& name, double value);
  // What was set, or the default. Throws Status::kNotFound for an unknown name.
  double operator[](const std::string& name) const;

 private:
  std::map<std::string, double> values_;
};

}  // namespace mimo::tasks
