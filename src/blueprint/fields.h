// Fields on request, which the scene's worlds observe beside what agents and cameras give.
#pragma once

#include <vector>

#include "access/requested_fields.h"

namespace mimo::blueprint {

class Fields {
 public:
  const std::vector<access::FieldOptions>& all() const { return fields_; }
  // No two of a name, and none of what no field can be.
  void add(const access::FieldOptions& field);
  // Makes the sense that fills them; empty where there are none.
  env::FurtherSense sense() const;

 private:
  std::vector<access::FieldOptions> fields_;
};

}  // namespace mimo::blueprint
