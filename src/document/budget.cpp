#include "document/budget.h"

#include <algorithm>

#include "base/fail.h"
#include "document/lines.h"
#include "engine/schema.h"

namespace mimo::document {

void Budget::add_time(pugi::xml_node node, double seconds) {
  constexpr double kMillisecond = 1e-3;
  seconds_ += seconds;
  if (seconds_ <= static_cast<double>(limits_.compile_ms) * kMillisecond) return;
  fail(Status::kModel,
       "{}: with this <{}>, compiling the document would take about {:.3g} s, more than max_compile_ms ({})",
       where(node), node.name(), seconds_, limits_.compile_ms);
}

void Budget::add_bytes(pugi::xml_node node, double bytes) {
  bytes_ += bytes;
  const auto allowed = static_cast<double>(limits_.world_bytes);
  if (bytes_ > allowed) {
    fail(Status::kModel, "{}: with this <{}>, the model would have about {:.3g} bytes, more than max_world_bytes ({})",
         where(node), node.name(), bytes_, limits_.world_bytes);
  }
  if (bytes_ > engine::most_model_bytes()) {
    fail(Status::kModel, "{}: with this <{}>, the model would have about {:.3g} bytes, more than {} can count ({:.0f})",
         where(node), node.name(), bytes_, engine::compiler_name(), engine::most_model_bytes());
  }
}

}  // namespace mimo::document
