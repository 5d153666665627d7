#include "growth/grow.h"

#include "growth/closure.h"
#include "growth/masses.h"
#include "growth/original/original.h"
#include "growth/range.h"
#include "growth/strength.h"
#include "growth/tone.h"

namespace mimo::growth {

Skeleton grown(const Skeleton& base, const Growth& growth) {
  check(growth);
  if (growth.model == Model::kOriginal) return grown_as_original(base, growth.age);
  Skeleton body = fit(base, growth).skeleton;
  strengthen(body, base, growth);
  spread_mass(body, growth.age);
  limit(body, growth);
  set_tone(body, base, growth);
  return body;
}

}  // namespace mimo::growth
