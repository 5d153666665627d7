#include "senses/touch/pain.h"

#include <algorithm>
#include <cmath>

#include "receptors/nociceptors.h"

namespace mimo::senses::touch {

Pain::Pain(const std::vector<Patch>& patches, double tick)
    : patches_(patches),
      kept_(std::exp(-tick / receptors::kFastAdapts)),
      over_(patches.size()),
      adapted_(patches.size()),
      fast_(patches.size()),
      slow_(patches.size()),
      restless_(patches.size()) {}

void Pain::rest() {
  restless_.clear();
  for (std::vector<double>* numbers : {&over_, &adapted_}) std::fill(numbers->begin(), numbers->end(), 0.0);
  for (std::vector<float>* rates : {&fast_, &slow_}) std::fill(rates->begin(), rates->end(), 0.0F);
}

void Pain::go_on(const Felt& felt, const Warmth& warmth) {
  for (const Prick& prick : felt.pricks()) {
    const auto sensor = static_cast<std::size_t>(prick.sensor);
    const double threshold = receptors::kPainfulPressure * receptors::pain_factor(patches_[sensor].region);
    over_[sensor] = std::max(over_[sensor], prick.pressure / threshold);
    restless_.add(prick.sensor);
  }
  const auto hurts = [](double degrees) {
    return receptors::slow_heat_rate(degrees) > 0 || receptors::fast_heat_rate(degrees) > 0;
  };
  for (const int sensor : warmth.restless()) {
    if (hurts(static_cast<double>(warmth.temperature()[static_cast<std::size_t>(sensor)]))) restless_.add(sensor);
  }
  restless_.each([&](std::size_t sensor) { return update(sensor, static_cast<double>(warmth.temperature()[sensor])); });
}

bool Pain::update(std::size_t sensor, double temperature) {
  using namespace receptors;
  const double over = over_[sensor];
  const double pressed = fast_pressure_rate(over, adapted_[sensor]);
  fast_[sensor] = static_cast<float>(std::min(kFastMost, pressed + fast_heat_rate(temperature)));
  slow_[sensor] = static_cast<float>(std::min(kSlowMost, slow_pressure_rate(over) + slow_heat_rate(temperature)));
  double& adapted = adapted_[sensor];
  adapted = over > 1 ? 1 - kept_ * (1 - adapted) : kept_ * adapted;
  if (adapted < 1e-3 && over <= 1) adapted = 0;
  over_[sensor] = 0;
  return adapted > 0 || fast_[sensor] > 0 || slow_[sensor] > 0;
}

void Pain::save(ByteWriter& to) const {
  to.put(Span<const double>(adapted_));
  to.put(Span<const float>(fast_));
  to.put(Span<const float>(slow_));
}

void Pain::load(ByteReader& from) {
  restless_.clear();
  for (double& adapted : adapted_) adapted = from.take_finite("a nociceptor");
  from.take(Span<float>(fast_));
  from.take(Span<float>(slow_));
  for (std::size_t i = 0; i < adapted_.size(); ++i) {
    if (adapted_[i] > 0 || fast_[i] > 0 || slow_[i] > 0) restless_.add(static_cast<int>(i));
  }
}

}  // namespace mimo::senses::touch
