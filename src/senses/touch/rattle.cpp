#include "senses/touch/rattle.h"

#include <algorithm>

#include "base/functions.h"

namespace mimo::senses::touch {
namespace {

constexpr double kStage = 0.040;      // s, of each stage of the filter: hops of 20 a second leave 1 % of themselves
constexpr double kHopping = 0.150;    // s, for which it goes on to be told of the mean after a hop
constexpr double kComingBack = 0.02;  // s, in which it then comes back to what is felt
constexpr double kLongestHop = 0.1;   // s
constexpr double kGravity = 9.81;     // m/s^2

}  // namespace

Rattle::Rattle(std::size_t sensors, std::size_t things, double tick)
    : Process("sliding touch"),
      things_(static_cast<double>(things)),
      tick_(tick),
      kept_(fixed::exp(-tick / kStage)),
      table_(sensors) {}

void Rattle::take_in(const Felt& felt) {
  for (const int sensor : felt.sensors()) {
    if (felt.of(sensor).lift > 0) table_.add(sensor);
    if (table_.has(static_cast<std::size_t>(sensor))) sharpness(sensor) = 0;
  }
  for (const Prick& prick : felt.pricks()) {
    if (!table_.has(static_cast<std::size_t>(prick.sensor))) continue;
    const double sharp = prick.pressure / fixed::cbrt(felt.of(prick.sensor).normal);
    sharpness(prick.sensor) = std::max(sharpness(prick.sensor), sharp);
  }
}

void Rattle::settle(std::size_t place, const Feeling& feeling, double smoothed) {
  double &doubt = table_[kDoubt][place], &air = table_[kAir][place];
  const bool hops = feeling.normal == 0 && air > 0;
  doubt = std::max(0.0, doubt - tick_);
  if (feeling.normal > 0) {
    air = feeling.lift > 0 ? std::min(tick_ + 2 * feeling.lift / kGravity, kLongestHop) : 0;
    table_[kSpeed][place] = feeling.sliding / feeling.normal;
    table_[kOther][place] = feeling.other;
  } else {
    air = std::max(0.0, air - tick_);
  }
  if (hops) {
    doubt = kHopping + kComingBack;
  } else if (!(feeling.lift > 0)) {
    doubt = std::min(doubt, kComingBack);
    if (feeling.normal == 0) table_[kSpeed][place] = 0;
  }
  if (doubt == 0 && air == 0) return table_.remove(place);
  double told = smoothed;
  for (std::size_t stage = kMean; stage < kMean + kStages; ++stage) {
    double& mean = table_[stage][place];
    if (doubt > 0) told += kept_ * (mean - told);
    mean = told;
  }
  table_[kTold][place] = smoothed + std::min(1.0, doubt / kComingBack) * (told - smoothed);
}

Rattle::Slide Rattle::slide(std::size_t sensor) const {
  if (!table_.has(sensor)) return {0, -1};
  return {table_.number(kSpeed, sensor), static_cast<int>(table_.number(kOther, sensor))};
}

void Rattle::save(ByteWriter& to) const {
  for (std::size_t sensor = 0; sensor < table_.sensor_count(); ++sensor) {
    for (std::size_t column = 0; column < kStates; ++column) to.put(table_.number(column, sensor));
  }
}

void Rattle::load(ByteReader& from) {
  table_.clear();
  for (std::size_t sensor = 0; sensor < table_.sensor_count(); ++sensor) {
    std::array<double, kStates> state;
    for (double& number : state) number = from.take_finite("a sliding touch");
    require(state[kOther] >= -1 && state[kOther] < things_,
            "the state holds {} for what slides over skin, expected a geom", state[kOther]);
    if (state[kDoubt] <= 0 && state[kAir] <= 0) continue;
    const std::size_t place = table_.add(static_cast<int>(sensor));
    for (std::size_t column = 0; column < kStates; ++column) table_[column][place] = state[column];
  }
}

}  // namespace mimo::senses::touch
