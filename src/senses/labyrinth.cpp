#include "senses/labyrinth.h"

#include <mujoco/mjmodel.h>

#include <utility>

#include "base/numbers.h"

namespace mimo::senses {
namespace {

using observation::Field;
using observation::Signal;
using receptors::Afferent;

constexpr const char* kTypes[receptors::kAfferents] = {"/regular", "/irregular"};

// Labels of places in a head, each with both types of afferents.
std::vector<std::string> with_types(const char* const* places, std::size_t count) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < count; ++i) {
    for (const char* type : kTypes) labels.push_back(places[i] + std::string(type));
  }
  return labels;
}

Field rates(const char* name, std::vector<std::size_t> shape, const char* frame, std::vector<std::string> labels) {
  Field field;
  field.name = std::string("vestibular/") + name;
  field.shape = std::move(shape);
  field.unit = "Hz";
  field.frame = frame;
  field.low = 0;
  field.labels = std::move(labels);
  return field;
}

void write_canals(const receptors::Canals& canals, float* out) {
  for (std::size_t i = 0; i < receptors::kCanals; ++i) {
    for (const Afferent type : {Afferent::kRegular, Afferent::kIrregular}) {
      *out++ = static_cast<float>(canals.rate(i, type));
    }
  }
}

void write_macula(const receptors::Maculae& side, std::size_t macula, float*& out) {
  for (std::size_t direction = 0; direction < receptors::kDirections; ++direction) {
    for (const Afferent type : {Afferent::kRegular, Afferent::kIrregular}) {
      *out++ = static_cast<float>(side.rate(macula, direction, type));
    }
  }
}

}  // namespace

Labyrinth::Labyrinth(const Head& head, double tick)
    : Process("labyrinth"),
      head_(head),
      canals_(tick),
      maculae_{receptors::Maculae(true, tick), receptors::Maculae(false, tick)},
      gravity_(tick) {}

std::vector<Signal> Labyrinth::signals(std::uint32_t wanted) const {
  using namespace receptors;
  std::vector<Signal> signals;
  if (has_bit(wanted, MIMO_VESTIBULAR_CANALS)) {
    signals.push_back({rates("canals", {kCanals, kAfferents}, head_.frame, with_types(kCanalNames, kCanals)),
                       [this](const mjModel&, const mjData&, float* out) { write_canals(canals_, out); }});
  }
  if (has_bit(wanted, MIMO_VESTIBULAR_OTOLITHS)) {
    signals.push_back({rates("otoliths", {kSides, kMaculae, kDirections, kAfferents}, head_.frame,
                             with_types(kPolarisationNames, kPolarisations)),
                       [this](const mjModel&, const mjData&, float* out) {
                         for (const Maculae& side : maculae_) {
                           for (std::size_t macula = 0; macula < kMaculae; ++macula) write_macula(side, macula, out);
                         }
                       }});
  }
  if (has_bit(wanted, MIMO_VESTIBULAR_GRAVITY)) {
    Field field;
    field.name = "vestibular/gravity";
    field.shape = {3};
    field.unit = "m/s^2";
    field.frame = head_.frame;
    field.labels = {"x", "y", "z"};
    signals.push_back({field, [this](const mjModel&, const mjData&, float* out) {
                         Eigen::Map<Eigen::Vector3f>{out} = gravity_.up().cast<float>();
                       }});
  }
  return signals;
}

void Labyrinth::rest(const mjModel& model, const mjData& data) {
  const engine::Motion motion = engine::motion_of(model, data, head_.place);
  canals_.rest(motion.angular_velocity);
  for (std::size_t side = 0; side < receptors::kSides; ++side) {
    maculae_[side].rest(engine::acceleration_at(motion, head_.ears[side]));
  }
  gravity_.rest(motion.acceleration);
}

void Labyrinth::go_on(const mjModel& model, const mjData& data) {
  const engine::Motion motion = engine::motion_of(model, data, head_.place);
  canals_.advance(motion.angular_velocity);
  for (std::size_t side = 0; side < receptors::kSides; ++side) {
    maculae_[side].advance(engine::acceleration_at(motion, head_.ears[side]));
  }
  gravity_.advance(motion.acceleration, canals_.told());
}

void Labyrinth::save(ByteWriter& to) const {
  canals_.save(to);
  for (const receptors::Maculae& side : maculae_) side.save(to);
  gravity_.save(to);
}

void Labyrinth::load(ByteReader& from) {
  canals_.load(from);
  for (receptors::Maculae& side : maculae_) side.load(from);
  gravity_.load(from);
}

Labyrinth::Head head_with_ears(const mjModel& model, int head) {
  int largest = -1;
  for (int geom = model.body_geomadr[head]; geom < model.body_geomadr[head] + model.body_geomnum[head]; ++geom) {
    const bool sphere = model.geom_type[geom] == mjGEOM_SPHERE;
    if (sphere && (largest < 0 || model.geom_size[3 * geom] > model.geom_size[3 * largest])) largest = geom;
  }
  Labyrinth::Head found{{engine::Kind::kBody, head}, "head"};
  if (largest < 0) return found;
  const Eigen::Vector3d middle(model.geom_pos + 3 * largest);
  for (const bool left : {true, false}) {
    found.ears[left ? 0 : 1] = receptors::labyrinth_place(left, middle, model.geom_size[3 * largest]);
  }
  return found;
}

}  // namespace mimo::senses
