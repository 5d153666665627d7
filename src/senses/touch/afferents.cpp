#include "senses/touch/afferents.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/functions.h"
#include "receptors/skin.h"
#include "senses/touch/sensors.h"
#include "senses/touch/surface.h"

namespace mimo::senses::touch {
namespace {

using receptors::Region;

// On a regular grid of triangles a sensor has this share of its spacing's square to itself.
constexpr double kOfSquare = 0.87;

Region region_of(const mjModel& model, const body::Body& body, int id) {
  return touch::region_of(body::short_name(model, body, id));
}

double area_of(const mjModel& model, int body, const BornGeoms& born) {
  double sum = 0;
  for (const int geom : geoms_with_skin(model, body)) sum += area(born.shape(model, geom));
  return sum;
}

double density(Region region) {
  double sum = 0;
  for (std::size_t kind = 0; kind < receptors::kTouchKinds; ++kind) {
    sum += receptors::afferents_per_square_metre(region, kind);
  }
  return sum;
}

// How many afferents each body of an infant has.
std::map<int, double> afferents_by_body(const mjModel& model, const body::Body& body) {
  std::map<int, double> weights;
  if (!body.infant) return weights;
  const BornGeoms born(model, body);
  std::map<receptors::Territory, double> sums;
  for (const int id : body.bodies) {
    if (default_spacing(body::short_name(model, body, id)) == 0) continue;  // it holds something
    const Region region = region_of(model, body, id);
    weights[id] = density(region) * area_of(model, id, born);
    sums[receptors::territory_of(region)] += weights[id];
  }
  for (auto& [id, weight] : weights) {
    const receptors::Territory territory = receptors::territory_of(region_of(model, body, id));
    if (weight > 0) weight *= receptors::afferents_of(territory) / sums[territory];
  }
  return weights;
}

constexpr double kSmoothing = 0.010;  // s, of forces; and of PC's envelope
constexpr double kLeastForce = 1e-5;  // N
constexpr double kStill = 1e-5;       // m/s

}  // namespace

receptors::Region region_of(const std::string& name) {
  struct Part {
    const char* in_name;
    Region region;
  };
  constexpr Part kParts[] = {{"head", Region::kFace},     {"eye", Region::kEye},         {"metacarpal", Region::kHand},
                             {"hand", Region::kHand},     {"finger", Region::kFinger},   {"knuckle", Region::kFinger},
                             {"middle", Region::kFinger}, {"distal", Region::kFinger},   {"_th", Region::kFinger},
                             {"foot", Region::kFoot},     {"toe", Region::kFoot},        {"upper_arm", Region::kArm},
                             {"lower_arm", Region::kArm}, {"upper_leg", Region::kThigh}, {"lower_leg", Region::kLeg}};
  for (const Part& part : kParts) {
    if (name.find(part.in_name) != std::string::npos) return part.region;
  }
  return Region::kTrunk;
}

std::vector<Patch> patches(const mjModel& model, const body::Body& body, const Skin& skin) {
  const std::map<int, double> afferents = afferents_by_body(model, body);
  std::map<int, double> sensors;
  for (const Sensor& sensor : skin.sensors()) ++sensors[sensor.body];
  std::vector<Patch> patches;
  for (const Sensor& sensor : skin.sensors()) {
    if (!patches.empty() && sensor.body == skin.sensors()[patches.size() - 1].body) {
      patches.push_back(patches.back());
      continue;
    }
    const Region region = region_of(model, body, sensor.body);
    const double all = std::sqrt(area_of(model, sensor.body, {}) / kOfSquare);
    const double spacing = std::min(skin.spacing(sensor.body), all);
    const auto known = afferents.find(sensor.body);
    patches.push_back({region, spacing,
                       known != afferents.end() ? known->second / sensors[sensor.body]
                                                : kOfSquare * spacing * spacing * density(region)});
  }
  return patches;
}

Afferents::Afferents(const std::vector<Patch>& patches, Rattle& rattle, double slip_threshold, double tick)
    : patches_(patches),
      rattle_(rattle),
      slip_threshold_(slip_threshold),
      tick_(tick),
      kept_(fixed::exp(-tick / kSmoothing)),
      table_(patches.size()) {}

void Afferents::add(int sensor) {
  table_[kSpacing][table_.add(sensor)] = patches_[static_cast<std::size_t>(sensor)].spacing;
}

// What presses has pressed for ever: no onset.
void Afferents::rest(const Felt& felt) {
  table_.clear();
  rattle_.clear();
  take_in(felt);
  for (std::size_t i = 0; i < table_.size(); ++i) {
    table_[kTold][i] = table_[kNormal][i] = table_[kFeltNormal][i];
    table_[kAlong][i] = table_[kFeltAlong][i];
    table_[kAcross][i] = table_[kFeltAcross][i];
    table_[kDepth][i] = receptors::indentation(table_[kNormal][i], table_[kSpacing][i]);
    tell(i, {0, -1}, {});
  }
}

void Afferents::go_on(const Felt& felt) {
  take_in(felt);
  smooth(felt);
  for (std::size_t i = table_.size(); i-- > 0;) {
    if (gone(i)) table_.remove(i);
  }
}

void Afferents::take_in(const Felt& felt) {
  for (const int sensor : felt.sensors()) add(sensor);
  for (const std::size_t part : {kFeltNormal, kFeltAlong, kFeltAcross}) std::fill_n(table_[part], table_.size(), 0.0);
  for (const int sensor : felt.sensors()) {
    const auto place = static_cast<std::size_t>(table_.place(static_cast<std::size_t>(sensor)));
    const Feeling& feeling = felt.of(sensor);
    table_[kFeltNormal][place] = feeling.normal;
    table_[kFeltAlong][place] = feeling.tangent.x();
    table_[kFeltAcross][place] = feeling.tangent.y();
  }
}

// Sliding contacts count with their mean pressure.
void Afferents::steady(const Felt& felt) {
  std::copy_n(table_[kNormal], table_.size(), table_[kTold]);
  rattle_.advance(felt, [this](std::size_t sensor) { return table_.number(kNormal, sensor); });
  rattle_.tell([this](std::size_t sensor, double force) {
    if (table_.has(sensor)) table_[kTold][static_cast<std::size_t>(table_.place(sensor))] = force;
  });
}

void Afferents::smooth(const Felt& felt) {
  const auto smoothed = [this](const Row& before, const Row& now) -> Row { return now + kept_ * (before - now); };
  for (std::size_t i = 0; i < table_.size(); i += kRow) {
    for (const std::size_t part : {0, 1, 2}) {
      table_.row(kNormal + part, i) = smoothed(table_.row(kNormal + part, i), table_.row(kFeltNormal + part, i));
    }
  }
  steady(felt);
  for (std::size_t i = 0; i < table_.size(); i += kRow) {
    const Row depth = receptors::indentation<Row>(table_.row(kTold, i), table_.row(kSpacing, i));
    const Row speed = (depth - table_.row(kDepth, i)) / tick_;
    const Row jolt = receptors::pc_rate<Row>((speed - table_.row(kSpeed, i)) / tick_);
    table_.row(kJolts, i) = smoothed(table_.row(kJolts, i), jolt);
    table_.row(kDepth, i) = depth;
    table_.row(kSpeed, i) = speed;
  }
  for (std::size_t i = 0; i < table_.size(); ++i) {
    if (table_[kJolts][i] < receptors::kSilent) table_[kJolts][i] = 0;
  }
}

bool Afferents::gone(std::size_t place) const {
  return table_[kFeltNormal][place] == 0 && std::max(table_[kNormal][place], table_[kTold][place]) < kLeastForce &&
         std::abs(table_[kSpeed][place]) < kStill && table_[kJolts][place] == 0;
}

void Afferents::tell(const Felt& felt, const Things& things) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    tell(i, slide(felt, static_cast<std::size_t>(table_.sensors()[i])), things);
  }
}

Rattle::Slide Afferents::slide(const Felt& felt, std::size_t sensor) const {
  const Feeling& feeling = felt.of(static_cast<int>(sensor));
  if (feeling.normal > 0) return {feeling.sliding / feeling.normal, feeling.other};
  return rattle_.slide(sensor);
}

void Afferents::tell(std::size_t place, const Rattle::Slide& slide, const Things& things) {
  const auto value = [&](Column column) { return table_[column][place]; };
  double ra = receptors::ra_rate(value(kSpeed)), pc = value(kJolts);
  if (slide.speed > slip_threshold_ && slide.other >= 0) {
    const Thing& thing = things[slide.other];
    ra += receptors::ra_of_sliding(slide.speed, {thing.wavelength, thing.amplitude});
    pc += receptors::pc_of_sliding(slide.speed, {thing.wavelength, thing.amplitude});
  }
  const auto put = [&](Rate rate, double hertz) { table_[kFirstRate + std::size_t{rate}][place] = hertz; };
  put(kSa1, receptors::sa1_rate(value(kDepth), value(kSpeed)));
  put(kRa, ra);
  put(kPc, pc);
  const Patch& patch = patches_[static_cast<std::size_t>(table_.sensors()[place])];
  const double along = value(kAlong), across = value(kAcross);
  const bool stretched = value(kNormal) >= kLeastForce && patch.region != receptors::Region::kFinger;
  // Friction goes with the normal force.
  const double share = value(kNormal) > 0 ? value(kTold) / value(kNormal) : 1;
  const double force = std::sqrt(along * along + across * across);
  const double all = receptors::stretch(share * force, patch.spacing);
  const auto channel = [&](double part) {
    return stretched ? receptors::sa2_rate(force > 0 ? all * part / force : 0, all) : 0;
  };
  put(kSa2Along, channel(along));
  put(kSa2Across, channel(across));
}

void Afferents::save(ByteWriter& to) const {
  for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) {
    for (std::size_t column = 0; column < kStates; ++column) to.put(table_.number(column, sensor));
  }
  const auto put = [&](std::size_t rate, std::size_t sensor) {
    to.put(static_cast<float>(table_.number(kFirstRate + std::size_t{rate}, sensor)));
  };
  for (const std::size_t rate : {kSa1, kRa, kPc}) {
    for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) put(rate, sensor);
  }
  for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) {
    for (const std::size_t rate : {kSa2Along, kSa2Across}) put(rate, sensor);
  }
}

void Afferents::load(ByteReader& from) {
  table_.clear();
  for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) {
    std::array<double, kStates> state;
    for (double& number : state) number = from.take_finite("a touch afferent");
    if (state[kNormal] == 0 && state[kJolts] == 0 && state[kSpeed] == 0) continue;
    add(static_cast<int>(sensor));
    for (std::size_t column = 0; column < kStates; ++column) table_[column][table_.size() - 1] = state[column];
  }
  const auto take = [&](std::size_t rate, std::size_t sensor) {
    const float hertz = from.take<float>();
    if (!table_.has(sensor)) return;
    table_[kFirstRate + std::size_t{rate}][static_cast<std::size_t>(table_.place(sensor))] = static_cast<double>(hertz);
  };
  for (const std::size_t rate : {kSa1, kRa, kPc}) {
    for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) take(rate, sensor);
  }
  for (std::size_t sensor = 0; sensor < patches_.size(); ++sensor) {
    for (const std::size_t rate : {kSa2Along, kSa2Across}) take(rate, sensor);
  }
}

}  // namespace mimo::senses::touch
