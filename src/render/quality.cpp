#include <algorithm>

#include "base/fail.h"
#include "render/renderer.h"

namespace mimo::render {

void require_samples(std::int64_t samples) {
  const auto known = {0, 1, 4, 16, 64};
  require(std::find(known.begin(), known.end(), samples) != known.end(),
          "samples is {}, expected 1, 4, 16 or 64, or 0 for the renderer's own", samples);
}

}  // namespace mimo::render
