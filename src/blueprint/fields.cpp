#include "blueprint/fields.h"

#include "base/fail.h"
#include "env/requested_fields.h"

namespace mimo::blueprint {

void Fields::add(const env::FieldOptions& field) {
  env::check(field);
  for (const env::FieldOptions& other : fields_) {
    require(other.name != field.name, "name: there is a field \"{}\" already", field.name);
  }
  fields_.push_back(field);
}

}  // namespace mimo::blueprint
