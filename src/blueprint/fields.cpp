#include "blueprint/fields.h"

#include "access/requested_fields.h"
#include "base/fail.h"

namespace mimo::blueprint {

void Fields::add(const access::FieldOptions& field) {
  access::check(field);
  for (const access::FieldOptions& other : fields_) {
    require(other.name != field.name, "name: there is a field \"{}\" already", field.name);
  }
  fields_.push_back(field);
}

env::FurtherSense Fields::sense() const {
  if (fields_.empty()) return {};
  return [fields = fields_](const mjModel& model, const env::World* world) {
    return std::make_unique<access::RequestedFields>(model, world, fields);
  };
}

}  // namespace mimo::blueprint
