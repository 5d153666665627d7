#include "receptors/thermoreceptors.h"

namespace mimo::receptors {
namespace {

Eight bell(const Eight& x) { return (-x * x).exp(); }

}  // namespace

Eight cold_rates(const Eight& temperature, const Eight& change) {
  return (8 * bell((temperature - 30) / 6) - 20 * change).max(0.0F);
}

Eight warm_rates(const Eight& temperature, const Eight& change) {
  return (12 * bell((temperature - 41) / 5) + 10 * change).max(0.0F);
}

}  // namespace mimo::receptors
