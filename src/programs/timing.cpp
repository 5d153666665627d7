#include "programs/timing.h"

namespace cli {

std::vector<std::pair<std::string, double>> split_ms(const mimo_timing& timing, double total_ms) {
  const double scale = timing.steps == 0 ? 0 : 1000.0 / static_cast<double>(timing.steps);
  std::vector<std::pair<std::string, double>> split = {{"physics", timing.physics * scale},
                                                       {"touch", timing.touch * scale},
                                                       {"vision", timing.vision * scale},
                                                       {"proprioception", timing.proprioception * scale},
                                                       {"vestibular", timing.vestibular * scale}};
  if (timing.hearing > 0) split.emplace_back("hearing", timing.hearing * scale);
  double other = total_ms;
  for (const auto& part : split) other -= part.second;
  split.emplace_back("other", other);
  return split;
}

}  // namespace cli
