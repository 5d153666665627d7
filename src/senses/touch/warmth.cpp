#include "senses/touch/warmth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/fail.h"
#include "base/functions.h"
#include "body/face.h"
#include "receptors/skin.h"

namespace mimo::senses::touch {
namespace {

using receptors::Eight;

constexpr double kTouching = 1e-3;  // N, smoothed
constexpr double kRested = 1e-4;    // degrees
constexpr double kRounding = 1e-3;  // degrees, more than rounding makes

// Of eight receptors: how warm they are, and how fast that changes.
struct Eights {
  Eights(const double* surface, const double* at, double lag) {
    for (int i = 0; i < 8; ++i) {
      temperature[i] = static_cast<float>(at[i]);
      change[i] = static_cast<float>((surface[i] - at[i]) / lag);
    }
  }
  Eight temperature, change;
};

constexpr double kFresh = 1e-3;  // less fatigue counts as none

// The distal parts of the limbs may lack C-tactile afferents (Vallbo 1999).
bool is_hairy(receptors::Region region) {
  using receptors::Region;
  return region == Region::kFace || region == Region::kTrunk || region == Region::kArm || region == Region::kThigh ||
         region == Region::kLeg;
}

// Between the corners of the mouth; how high they are is an estimate.
bool is_on_lips(const body::Mouth& mouth, const Vec3& position) {
  constexpr double kHeight = 0.36;  // of their width
  const Vec3 at = position - mouth.middle, &corner = mouth.corners[0];
  if (!(at.x() > 0)) return false;
  const double side = at.y() / at.x(), up = at.z() / at.x(), width = corner.y() / corner.x();
  return std::abs(side) <= width && std::abs(up - corner.z() / corner.x()) <= kHeight * width;
}

}  // namespace

Warmth::Warmth(const std::vector<Patch>& patches, const Things& things, double tick)
    : things_(things),
      rest_(receptors::resting_temperature({37, things.air})),
      tick_(tick),
      kept_(receptors::skin_kept({37, things.air}, tick)),
      kept_cold_(fixed::exp(-tick / receptors::kColdLag)),
      kept_warm_(fixed::exp(-tick / receptors::kWarmLag)),
      cold_at_rest_(receptors::cold_rates(Eight::Constant(as_told(rest_)), Eight::Zero())[0]),
      warm_at_rest_(receptors::warm_rates(Eight::Constant(as_told(rest_)), Eight::Zero())[0]),
      touched_(patches.size()),
      free_(patches.size()),
      temperature_(patches.size()),
      cold_(patches.size()),
      warm_(patches.size()) {
  for (const Patch& patch : patches) factors_.push_back(static_cast<float>(receptors::thermal_factor(patch.region)));
  rest();
}

void Warmth::rest() {
  touched_.clear();
  free_.clear();
  coldest_ = warmest_ = rest_;
  for (std::size_t i = 0; i < temperature_.size(); ++i) tell_rest(i);
}

void Warmth::go_on(const Felt& felt, const Afferents& afferents) {
  for (const int sensor : afferents.restless()) {
    if (afferents.force(static_cast<std::size_t>(sensor)) > kTouching) touch(sensor, felt.of(sensor).other);
  }
  // A contact that breaks for a step or two goes on: the smoothed force tells.
  for (std::size_t i = touched_.size(); i-- > 0;) {
    if (afferents.force(static_cast<std::size_t>(touched_.sensors()[i])) <= kTouching) let_go(i);
  }
  follow_things();
  come_back();
}

void Warmth::touch(int sensor, int other) {
  if (other < 0) return;
  const int known = touched_.place(static_cast<std::size_t>(sensor));
  if (known != Touched::kNone) {
    const auto place = static_cast<std::size_t>(known);
    if (touched_[kOther][place] != other) begin(place, other, touched_[kSurface][place]);
    return;
  }
  const std::size_t place = touched_.add(sensor);
  const int before = free_.place(static_cast<std::size_t>(sensor));
  for (std::size_t column = 0; column < kFreeColumns; ++column) {
    touched_[column][place] = before == Free::kNone ? rest_ : free_[column][static_cast<std::size_t>(before)];
  }
  if (before != Free::kNone) free_.remove(static_cast<std::size_t>(before));
  begin(place, other, touched_[kSurface][place]);
}

void Warmth::begin(std::size_t place, int other, double before) {
  const Thing& thing = things_[other];
  const receptors::Touching touching = receptors::touching(before, thing.temperature, thing.effusivity);
  touched_[kBefore][place] = touching.before;
  touched_[kSwing][place] = touching.swing;
  touched_[kPace][place] = touching.pace;
  touched_[kSince][place] = 0;
  touched_[kOther][place] = other;
  coldest_ = std::min({coldest_, before - kRounding, before + touching.swing - kRounding});
  warmest_ = std::max({warmest_, before + kRounding, before + touching.swing + kRounding});
}

void Warmth::let_go(std::size_t place) {
  const std::size_t to = free_.add(touched_.sensors()[place]);
  for (std::size_t column = 0; column < kFreeColumns; ++column) free_[column][to] = touched_[column][place];
  touched_.remove(place);
}

void Warmth::follow_things() {
  for (std::size_t i = 0; i < touched_.size(); i += kRow) {
    const Row since = touched_.row(kSince, i) + tick_;
    const receptors::TouchingOf<Row> by = {touched_.row(kBefore, i), touched_.row(kSwing, i), touched_.row(kPace, i)};
    const Row surface = receptors::touched_temperature(by, since);
    touched_.row(kSince, i) = since;
    touched_.row(kSurface, i) = surface;
    touched_.row(kAtCold, i) = surface + kept_cold_ * (touched_.row(kAtCold, i) - surface);
    touched_.row(kAtWarm, i) = surface + kept_warm_ * (touched_.row(kAtWarm, i) - surface);
  }
}

void Warmth::come_back() {
  free_.pad(kSurface, rest_ + 1);
  Row least_off = Row::Constant(1);
  for (std::size_t i = 0; i < free_.size(); i += kRow) {
    const Row surface = rest_ + kept_ * (free_.row(kSurface, i) - rest_);
    const Row at_cold = surface + kept_cold_ * (free_.row(kAtCold, i) - surface);
    const Row at_warm = surface + kept_warm_ * (free_.row(kAtWarm, i) - surface);
    free_.row(kSurface, i) = surface;
    free_.row(kAtCold, i) = at_cold;
    free_.row(kAtWarm, i) = at_warm;
    least_off = least_off.min((surface - rest_).abs().max((at_cold - rest_).abs()).max((at_warm - rest_).abs()));
  }
  if (!(least_off.minCoeff() <= kRested)) return;
  for (std::size_t i = free_.size(); i-- > 0;) {
    const auto rested = [&](Column column) { return std::abs(free_[column][i] - rest_) <= kRested; };
    if (!rested(kSurface) || !rested(kAtCold) || !rested(kAtWarm)) continue;
    tell_rest(static_cast<std::size_t>(free_.sensors()[i]));
    free_.remove(i);
  }
}

float Warmth::now(std::size_t sensor) const {
  if (touched_.place(sensor) != Touched::kNone) return as_told(touched_.number(kSurface, sensor));
  return as_told(free_.place(sensor) == Free::kNone ? rest_ : free_.number(kSurface, sensor));
}

void Warmth::tell(bool rates) {
  tell(touched_, rates);
  tell(free_, rates);
}

template <typename Table>
void Warmth::tell(const Table& table, bool rates) {
  table.spread(kSurface, temperature_.data());
  for (std::size_t first = 0; rates && first < table.size(); first += kRow) {
    const double* const surface = table[kSurface] + first;
    const Eights cold(surface, table[kAtCold] + first, receptors::kColdLag);
    const Eights warm(surface, table[kAtWarm] + first, receptors::kWarmLag);
    const Eight cold_rates = receptors::cold_rates(cold.temperature, cold.change);
    const Eight warm_rates = receptors::warm_rates(warm.temperature, warm.change);
    const std::size_t count = std::min(kRow, table.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const auto sensor = static_cast<std::size_t>(table.sensors()[first + i]);
      cold_[sensor] = factors_[sensor] * cold_rates[static_cast<Eigen::Index>(i)];
      warm_[sensor] = factors_[sensor] * warm_rates[static_cast<Eigen::Index>(i)];
    }
  }
}

void Warmth::tell_rest(std::size_t sensor) {
  temperature_[sensor] = as_told(rest_);
  cold_[sensor] = factors_[sensor] * cold_at_rest_;
  warm_[sensor] = factors_[sensor] * warm_at_rest_;
}

void Warmth::save(ByteWriter& to) const {
  for (std::size_t sensor = 0; sensor < temperature_.size(); ++sensor) {
    const bool touched = touched_.place(sensor) != Touched::kNone, free = free_.place(sensor) != Free::kNone;
    for (std::size_t column = 0; column < kFreeColumns; ++column) {
      to.put(touched ? touched_.number(column, sensor) : free ? free_.number(column, sensor) : rest_);
    }
    to.put(touched_.number(kBefore, sensor));
    to.put(touched_.number(kSince, sensor));
    to.put(touched ? static_cast<std::int32_t>(touched_.number(kOther, sensor)) : std::int32_t{-1});
  }
}

void Warmth::load(ByteReader& from) {
  rest();
  for (std::size_t sensor = 0; sensor < temperature_.size(); ++sensor) {
    std::array<double, 5> state;  // the columns that are free, before, since
    for (double& number : state) number = from.take_finite("skin's temperature");
    const auto other = from.take<std::int32_t>();
    const auto things = static_cast<std::int64_t>(things_.all.size());
    require(other < things && state[4] >= 0, "the state holds skin that geom {} touches for {} s", other, state[4]);
    const auto put = [&](auto& table) {
      const std::size_t place = table.add(static_cast<int>(sensor));
      for (std::size_t column = 0; column < kFreeColumns; ++column) table[column][place] = state[column];
      coldest_ = std::min(coldest_, state[kSurface] - kRounding);
      warmest_ = std::max(warmest_, state[kSurface] + kRounding);
      return place;
    };
    const auto off = [this](double degrees) { return degrees != rest_; };
    if (other >= 0) {
      const std::size_t place = put(touched_);
      begin(place, other, state[3]);
      touched_[kSince][place] = state[4];
    } else if (off(state[kSurface]) || off(state[kAtCold]) || off(state[kAtWarm])) {
      put(free_);
    }
  }
  tell(true);
}

Pain::Pain(const std::vector<Patch>& patches, double tick)
    : patches_(patches), kept_(fixed::exp(-tick / receptors::kFastAdapts)), table_(patches.size()) {}

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

Caresses::Caresses(const mjModel& model, const body::Body& body, const Skin& skin, const std::vector<Patch>& patches,
                   double slip_threshold, double tick)
    : hairy_(patches.size()),
      slip_threshold_(slip_threshold),
      tick_(tick),
      kept_(receptors::ct_fatigue(1, 0, tick)),
      table_(patches.size()) {
  const std::optional<body::Mouth> mouth = body::find_mouth(model, body);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Sensor& sensor = skin.sensors()[i];
    const bool on_lips = mouth && sensor.body == body.head && is_on_lips(*mouth, sensor.position);
    hairy_[i] = is_hairy(patches[i].region) && !on_lips ? 1 : 0;
  }
}

void Caresses::go_on(const Felt& felt, const Afferents& afferents, const Warmth& warmth) {
  for (const int id : afferents.restless()) {
    const auto sensor = static_cast<std::size_t>(id);
    if (hairy_[sensor] == 0) continue;
    const double speed = afferents.slide(felt, sensor).speed;
    if (!(speed > slip_threshold_)) continue;
    table_[kDrive][table_.add(id)] = receptors::ct_drive(speed, static_cast<double>(warmth.now(sensor)));
  }
  for (std::size_t i = table_.size(); i-- > 0;) {
    double &fatigue = table_[kFatigue][i], &drive = table_[kDrive][i];
    fatigue = drive == 0 ? kept_ * fatigue : receptors::ct_fatigue(fatigue, drive, tick_);
    table_[kRate][i] = drive * (1 - fatigue);
    if (drive == 0 && fatigue < kFresh)
      table_.remove(i);
    else
      drive = 0;
  }
}

void Caresses::save(ByteWriter& to) const {
  for (std::size_t sensor = 0; sensor < hairy_.size(); ++sensor) {
    for (const std::size_t column : {kFatigue, kRate}) to.put(table_.number(column, sensor));
  }
}

void Caresses::load(ByteReader& from) {
  table_.clear();
  for (std::size_t sensor = 0; sensor < hairy_.size(); ++sensor) {
    const double fatigue = from.take_finite("a C-tactile afferent"), rate = from.take_finite("a C-tactile afferent");
    require(fatigue >= 0 && fatigue <= 1 && rate >= 0, "the state holds a C-tactile afferent with fatigue {} and {} Hz",
            fatigue, rate);
    if (fatigue == 0 && rate == 0) continue;
    const std::size_t place = table_.add(static_cast<int>(sensor));
    table_[kFatigue][place] = fatigue;
    table_[kRate][place] = rate;
  }
}

}  // namespace mimo::senses::touch
