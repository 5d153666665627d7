#include "motion/size.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr double kOldest = 24, kGrid = 3, kNear = 0.05;  // months

class AgeSearch {
 public:
  AgeSearch(const Markers& markers, const RetargetOptions& options, const WorldOptions& world)
      : markers_(markers), options_(options), world_(world) {
    // The age has to explain lengths as they are; what it leaves is scaled afterwards.
    if (!markers.in_pixels && options_.scale == 0) options_.scale = 1;
  }

  double cost(double months) {
    const auto known = costs_.find(months);
    if (known != costs_.end()) return known->second;
    WorldOptions world = world_;
    world.age.age = months;
    mimo::Env env = open_bare_world(world, make_env_config());
    const Movement movement = point_movement(markers_, options_, env);
    return costs_[months] = misfit(movement, env, poses_);
  }

  double best() const {
    const auto smaller = [](const auto& a, const auto& b) { return a.second < b.second; };
    return std::min_element(costs_.begin(), costs_.end(), smaller)->first;
  }

  // From the youngest to the oldest age that was tried and whose distances are at most a tenth larger.
  std::pair<double, double> as_good() const {
    const double most = 1.21 * costs_.at(best());
    std::pair<double, double> range(kOldest, 0);
    for (const auto& [months, cost] : costs_) {
      if (cost > most) continue;
      range = {std::min(range.first, months), std::max(range.second, months)};
    }
    return range;
  }

 private:
  const Markers& markers_;
  RetargetOptions options_;
  const WorldOptions& world_;
  std::vector<std::vector<double>> poses_;
  std::map<double, double> costs_;  // by age
};

}  // namespace

bool is_age_open(const WorldOptions& options) {
  const std::vector<std::string> scenes = mimo::scene_names();
  return !options.age.age && !options.age.physiological_age && options.body.empty() &&
         std::find(scenes.begin(), scenes.end(), options.scene) != scenes.end();
}

FoundAge fit_age(const Markers& markers, const RetargetOptions& options, const WorldOptions& world) {
  constexpr double kGolden = 0.6180339887498949;
  AgeSearch search(markers, options, world);
  for (double months = kOldest; months >= 0; months -= kGrid) search.cost(months);
  double low = std::max(0.0, search.best() - kGrid), high = std::min(kOldest, search.best() + kGrid);
  while (high - low > kNear) {
    const double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    if (search.cost(left) < search.cost(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  const double months = search.best();
  const auto [youngest, oldest] = search.as_good();
  return {months,
          markers.source + text(": an infant of %.3g months fits the points best; from %.3g to %.3g months they "
                                "are at most a tenth farther off (--age takes another)",
                                months, youngest, oldest)};
}

}  // namespace cli
