#include "senses/touch/pain.h"

#include <algorithm>
#include <cmath>

#include "receptors/nociceptors.h"

namespace mimo::senses::touch {

Pain::Pain(const std::vector<Patch>& patches, double tick)
    : patches_(patches), kept_(std::exp(-tick / receptors::kFastAdapts)), table_(patches.size()) {}

void Pain::prick(int sensor, double pressure) {
  const receptors::Region region = patches_[static_cast<std::size_t>(sensor)].region;
  const double threshold = receptors::kPainfulPressure * receptors::pain_factor(region);
  double& over = table_[kOver][table_.add(sensor)];
  over = std::max(over, pressure / threshold);
}

void Pain::go_on(const Felt& felt, const Rattle& rattle, const Warmth& warmth) {
  for (const Prick& each : felt.pricks()) {
    if (!rattle.doubts(static_cast<std::size_t>(each.sensor))) prick(each.sensor, each.pressure);
  }
  rattle.prick([this](int sensor, double pressure) { prick(sensor, pressure); });
  warmth.beyond(receptors::kPainfulCold, receptors::kPainfulHeat, [this](int sensor, float degrees) {
    if (receptors::slow_heat_rate(static_cast<double>(degrees)) > 0) table_.add(sensor);
  });
  for (std::size_t i = table_.size(); i-- > 0;) {
    const auto sensor = static_cast<std::size_t>(table_.sensors()[i]);
    if (!update(i, static_cast<double>(warmth.now(sensor)))) table_.remove(i);
  }
}

bool Pain::update(std::size_t place, double temperature) {
  using namespace receptors;
  double &over = table_[kOver][place], &adapted = table_[kAdapted][place];
  const double pressed = fast_pressure_rate(over, adapted);
  const double fast = std::min(kFastMost, pressed + fast_heat_rate(temperature));
  const double slow = std::min(kSlowMost, slow_pressure_rate(over) + slow_heat_rate(temperature));
  table_[kFirstRate + std::size_t{kFast}][place] = fast;
  table_[kFirstRate + std::size_t{kSlow}][place] = slow;
  adapted = over > 1 ? 1 - kept_ * (1 - adapted) : kept_ * adapted;
  if (adapted < 1e-3 && over <= 1) adapted = 0;
  over = 0;
  return adapted > 0 || fast > 0 || slow > 0;
}

void Pain::save(ByteWriter& to) const {
  for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) to.put(table_.number(kAdapted, sensor));
  for (const std::size_t rate : {kFast, kSlow}) {
    for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) {
      to.put(static_cast<float>(table_.number(kFirstRate + std::size_t{rate}, sensor)));
    }
  }
}

void Pain::load(ByteReader& from) {
  table_.clear();
  const auto put = [this](std::size_t column, std::size_t sensor, double number) {
    if (number > 0) table_[column][table_.add(static_cast<int>(sensor))] = number;
  };
  for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) {
    put(kAdapted, sensor, from.take_finite("a nociceptor"));
  }
  for (const std::size_t rate : {kFast, kSlow}) {
    for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) {
      put(kFirstRate + std::size_t{rate}, sensor, static_cast<double>(from.take<float>()));
    }
  }
}

}  // namespace mimo::senses::touch
