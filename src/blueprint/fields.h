// Fields on request, which the scene's worlds observe beside what agents and cameras give.
#pragma once

#include <vector>

#include "env/options.h"

namespace mimo::blueprint {

class Fields {
 public:
  const std::vector<env::FieldOptions>& all() const { return fields_; }
  // No two of a name, and none of what no field can be.
  void add(const env::FieldOptions& field);

 private:
  std::vector<env::FieldOptions> fields_;
};

}  // namespace mimo::blueprint
