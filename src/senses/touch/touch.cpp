#include "senses/touch/touch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "base/numbers.h"
#include "engine/model.h"
#include "observation/sense.h"
#include "receptors/skin.h"
#include "senses/touch/surface.h"
#include "senses/touch/warmth.h"

namespace mimo::senses {
namespace {

using engine::Kind;

// Bits of MIMO_TOUCH_ by what they need to know: how skin is pressed, how warm it is, what hurts it.
constexpr std::uint32_t kTouchNerves = MIMO_TOUCH_SA1 | MIMO_TOUCH_RA | MIMO_TOUCH_PC | MIMO_TOUCH_SA2;
constexpr std::uint32_t kWarmthNerves = MIMO_TOUCH_TEMPERATURE | MIMO_TOUCH_COLD | MIMO_TOUCH_WARM;
constexpr std::uint32_t kPainNerves = MIMO_TOUCH_NOCICEPTION_FAST | MIMO_TOUCH_NOCICEPTION_SLOW;
static_assert((kTouchNerves | kWarmthNerves | kPainNerves | MIMO_TOUCH_CT | MIMO_TOUCH_UNITS) == kSkinNerves);

// The kind of a memory follows from its length. C-tactile afferents keep as many bytes as nociceptors: without these,
// their memory has a version of its own.
constexpr std::uint32_t memory_version(std::uint32_t wanted) {
  return has_bit(wanted, MIMO_TOUCH_CT) && !has_bit(wanted, kPainNerves) ? 1 : 0;
}

const char* frame_name(TouchFrame frame) {
  switch (frame) {
    case TouchFrame::kBody: return "body";
    case TouchFrame::kWorld: return "world";
    case TouchFrame::kSkin: return "skin";
  }
  return "";
}

void check_names(const mjModel& model, const body::Body& body, const TouchOptions& options) {
  std::vector<std::string> there;
  for (const int id : body.bodies) {
    if (!touch::geoms_with_skin(model, id).empty()) there.push_back(body::short_name(model, body, id));
  }
  for (const auto& [name, spacing] : options.spacing) {
    if (std::find(there.begin(), there.end(), name) != there.end()) continue;
    fail(Status::kNotFound, "touch: no body \"{}\" with a surface for skin; there are: {}", name, join(there, ", "));
  }
}

// The default spacing of a body: what the model's document says in the tuple "mimo:touch", where
// bodies that are not named have no skin; else the infant's own.
class UsualSpacing {
 public:
  UsualSpacing(const mjModel& model, const body::Body& body)
      : scene_(engine::custom_tuple(model, body.prefix + names::kTouch, Kind::kBody)) {}

  double of(int id, const std::string& name) const {
    if (scene_.empty()) return touch::default_spacing(name);
    for (const engine::TupleEntry& entry : scene_) {
      if (entry.id == id) return entry.value;
    }
    return 0;
  }

 private:
  std::vector<engine::TupleEntry> scene_;
};

using observation::Field;
using observation::Signal;

// The process of a whole skin; later parts need what earlier ones found.
class Nerves : public observation::Process {
 public:
  Nerves(const mjModel& model, const body::Body& body, std::shared_ptr<const touch::Skin> skin,
         const TouchOptions& options, touch::ThingsPtr things, touch::Rattle& rattle, double tick)
      : Process("touch", memory_version(options.wanted)),
        skin_(std::move(skin)),
        things_(std::move(things)),
        patches_(touch::patches(model, body, *skin_)),
        wants_warmth_(has_bit(options.wanted, kWarmthNerves | kPainNerves | MIMO_TOUCH_CT)),
        wants_pain_(has_bit(options.wanted, kPainNerves)),
        wants_caresses_(has_bit(options.wanted, MIMO_TOUCH_CT)),
        wants_rates_of_warmth_(has_bit(options.wanted, MIMO_TOUCH_COLD | MIMO_TOUCH_WARM)),
        felt_(
            *skin_, options.response,
            {has_bit(options.wanted, kTouchNerves | kPainNerves | MIMO_TOUCH_CT), wants_pain_, options.slip_threshold},
            *things_),
        rattle_(rattle),
        afferents_(patches_, rattle, options.slip_threshold, tick),
        warmth_(patches_, *things_, tick),
        pain_(patches_, tick),
        caresses_(model, body, *skin_, patches_, options.slip_threshold, tick) {}

  std::vector<Signal> signals(std::uint32_t wanted) const;

 private:
  void rest(const mjModel& model, const mjData& data) override {
    felt_.take_in(model, data);
    afferents_.rest(felt_);
    stale_ = false;
    warmth_.rest();
    pain_.rest();
    caresses_.rest();
  }
  void go_on(const mjModel& model, const mjData& data) override {
    felt_.take_in(model, data);
    afferents_.go_on(felt_);
    stale_ = true;
    if (wants_warmth_) warmth_.go_on(felt_, afferents_);
    if (wants_pain_) pain_.go_on(felt_, rattle_, warmth_);
    if (wants_caresses_) caresses_.go_on(felt_, afferents_, warmth_);
  }
  void save(ByteWriter& to) const override {
    tell();
    afferents_.save(to);
    if (wants_warmth_) warmth_.save(to);
    if (wants_pain_) pain_.save(to);
    if (wants_caresses_) caresses_.save(to);
  }
  void load(ByteReader& from) override {
    stale_ = false;
    afferents_.load(from);
    if (wants_warmth_) warmth_.load(from);
    if (wants_pain_) pain_.load(from);
    if (wants_caresses_) caresses_.load(from);
  }

  // Rates are worked out when they are looked at.
  void tell() const {
    if (!stale_) return;
    afferents_.tell(felt_, *things_);
    if (wants_warmth_) warmth_.tell(wants_rates_of_warmth_);
    stale_ = false;
  }

  // Fills all of a field.
  using Fill = std::function<void(float* out)>;
  Signal signal(const char* name, std::size_t channels, Fill fill, const char* unit = "Hz") const;
  // The same where most sensors are silent: fills in the others.
  Signal rate(const char* name, Fill fill, std::size_t channels = 1) const;
  Signal told(const char* name, const std::vector<float>& values, const char* unit = "Hz") const;
  Signal units() const;

  std::shared_ptr<const touch::Skin> skin_;
  touch::ThingsPtr things_;
  std::vector<touch::Patch> patches_;
  bool wants_warmth_, wants_pain_, wants_caresses_, wants_rates_of_warmth_;
  mutable bool stale_ = false;  // rates are of an earlier step
  touch::Felt felt_;
  const touch::Rattle& rattle_;
  mutable touch::Afferents afferents_;
  mutable touch::Warmth warmth_;
  touch::Pain pain_;
  touch::Caresses caresses_;
};

Signal Nerves::signal(const char* name, std::size_t channels, Fill fill, const char* unit) const {
  Field field;
  field.name = std::string("touch/") + name;
  field.shape = {skin_->sensors().size()};
  if (channels > 1) {
    field.shape.push_back(channels);
    field.frame = "skin";
  }
  field.unit = unit;
  if (unit == std::string("Hz")) field.low = 0;
  field.receptors = skin_->sensors();
  return {field, [this, fill = std::move(fill)](const mjModel&, const mjData&, float* out) {
            tell();
            fill(out);
          }};
}

Signal Nerves::rate(const char* name, Fill fill, std::size_t channels) const {
  return signal(name, channels, [count = channels * patches_.size(), fill = std::move(fill)](float* out) {
    std::fill_n(out, count, 0.0F);
    fill(out);
  });
}

Signal Nerves::told(const char* name, const std::vector<float>& values, const char* unit) const {
  return signal(
      name, 1, [&values](float* out) { std::copy(values.begin(), values.end(), out); }, unit);
}

// How many afferents of each kind a sensor stands for.
Signal Nerves::units() const {
  std::vector<float> counts;
  for (const touch::Patch& patch : patches_) {
    for (std::size_t kind = 0; kind < receptors::kTouchKinds; ++kind) {
      counts.push_back(static_cast<float>(patch.afferents * receptors::share_of(patch.region, kind)));
    }
  }
  const auto fill = [counts](float* out) { std::copy(counts.begin(), counts.end(), out); };
  Signal signal = this->signal("units", receptors::kTouchKinds, fill, "");
  signal.field.frame = "";
  signal.field.low = 0;
  return signal;
}

std::vector<Signal> Nerves::signals(std::uint32_t wanted) const {
  std::vector<Signal> signals;
  // Thinner nerves than those of touch are slower: cold 6.3 and warm 0.7 m/s (Hensel and Iggo 1971), pain 13 and 0.8.
  const auto add = [&](std::uint32_t bit, Signal signal, double share = 1, double speed = 0) {
    if (!has_bit(wanted, bit)) return;
    signal.field.nerve_share = share;
    signal.field.nerve_speed = speed;
    signals.push_back(std::move(signal));
  };
  const auto afferents = [this](touch::Afferents::Rate rate) {
    return [this, rate](float* out) { afferents_.fill_in(rate, out); };
  };
  const auto pain = [this](touch::Pain::Rate rate) { return [this, rate](float* out) { pain_.fill_in(rate, out); }; };
  const auto stretch = [this](float* out) {
    afferents_.fill_in(touch::Afferents::kSa2Along, out, 2);
    afferents_.fill_in(touch::Afferents::kSa2Across, out + 1, 2);
  };
  add(MIMO_TOUCH_SA1, rate("sa1", afferents(touch::Afferents::kSa1)));
  add(MIMO_TOUCH_RA, rate("ra", afferents(touch::Afferents::kRa)));
  add(MIMO_TOUCH_PC, rate("pc", afferents(touch::Afferents::kPc)));
  add(MIMO_TOUCH_SA2, rate("sa2", stretch, 2));
  add(MIMO_TOUCH_TEMPERATURE, told("temperature", warmth_.temperature(), "degC"));
  add(MIMO_TOUCH_COLD, told("cold", warmth_.cold()), 6.3 / 56);
  add(MIMO_TOUCH_WARM, told("warm", warmth_.warm()), 1, 0.7);
  add(MIMO_TOUCH_NOCICEPTION_FAST, rate("nociception_fast", pain(touch::Pain::kFast)), receptors::kFastShare);
  add(MIMO_TOUCH_NOCICEPTION_SLOW, rate("nociception_slow", pain(touch::Pain::kSlow)), 1, receptors::kSlowSpeed);
  add(MIMO_TOUCH_CT, rate("ct", [this](float* out) { caresses_.fill_in(out); }), 1, receptors::kCtSpeed);
  add(MIMO_TOUCH_UNITS, units());
  return signals;
}

}  // namespace

// Both are fields of one name.
void check_outputs(const TouchOptions& options) {
  constexpr std::uint32_t kBoth = MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE;
  require((options.wanted & kBoth) != kBoth,
          "touch is {:#x}: MIMO_TOUCH_FORCE and MIMO_TOUCH_NORMAL_FORCE exclude each other", options.wanted);
}

using touch::Press;
using touch::Share;
using touch::Side;
using touch::Vec3;

std::vector<touch::BodySpacing> spacings(const mjModel& model, const body::Body& body, const TouchOptions& options) {
  check_names(model, body, options);
  const UsualSpacing usual(model, body);
  std::vector<touch::BodySpacing> list;
  for (const int id : body.bodies) {
    const std::string name = body::short_name(model, body, id);
    const auto own = options.spacing.find(name);
    const double spacing =
        own != options.spacing.end() ? own->second : options.everywhere.value_or(usual.of(id, name) / options.scale);
    if (spacing > 0) list.push_back({id, spacing});
  }
  return list;
}

Touch::Touch(std::shared_ptr<const touch::Skin> skin, const TouchOptions& options)
    : options_(options), skin_(std::move(skin)), spread_(*skin_, options.response) {
  check_outputs(options);
  const char* frame = frame_name(options.frame);
  force_ = add(MIMO_TOUCH_FORCE, "touch/force", 3, "N", frame);
  normal_force_ = add(MIMO_TOUCH_NORMAL_FORCE, "touch/force", 1, "N", "");
  slip_ = add(MIMO_TOUCH_SLIP, "touch/slip", 2, "m/s", "skin");
  friction_use_ = add(MIMO_TOUCH_FRICTION_USE, "touch/friction_use", 1, "", "");
  if (slip_ == kNone && friction_use_ == kNone) return;
  pressure_.resize(skin_->sensors().size());
  pressed_.reserve(skin_->sensors().size());
}

int Touch::add(std::uint32_t bit, const char* name, std::size_t width, const char* unit, const char* frame) {
  const std::size_t sensors = skin_->sensors().size();
  if (!has_bit(options_.wanted, bit) || sensors == 0) return kNone;
  observation::Field field;
  field.name = name;
  field.shape = {sensors, width};
  field.unit = unit;
  field.frame = frame;
  field.receptors = skin_->sensors();
  if (width == 1) field.low = 0;
  if (*unit == '\0') field.high = 1;
  fields_.push_back(std::move(field));
  return static_cast<int>(fields_.size()) - 1;
}

void Touch::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  for (const observation::Field& field : fields_) std::fill_n(block + field.offset, field.bytes(), std::uint8_t{0});
  if (fields_.empty()) return;
  for (const engine::Meeting& met : engine::Contacts(model, data)) {
    const bool first = skin_->covers(met, 0), second = skin_->covers(met, 1);
    if (!first && !second) continue;
    const auto force = touch::pressing(model, data, met.number);
    if (!force) continue;
    if (first) feel(model, data, press_on(model, data, met, *force, Side::kFirst), block);
    if (second) feel(model, data, press_on(model, data, met, *force, Side::kSecond), block);
  }
  finish_means(block);
}

void Touch::feel(const mjModel& model, const mjData& data, const Press& press, std::uint8_t* block) {
  const Eigen::Matrix3d rotation =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.xmat + 9 * press.body);
  const Vec3 point = rotation.transpose() * (press.point - Vec3(data.xpos + 3 * press.body));
  const Span<const Share> shares = spread_.at(press.body, press.geom, point);
  if (force_ != kNone) add_force(press.force, rotation, shares, output(block, force_));
  if (float* out = output(block, normal_force_)) {
    for (const Share& share : shares) out[share.sensor] += static_cast<float>(share.weight * press.normal_force);
  }
  if (float* out = output(block, friction_use_)) {
    const double use = press.friction_use * press.normal_force;
    for (const Share& share : shares) out[share.sensor] += static_cast<float>(share.weight * use);
  }
  if (float* out = output(block, slip_)) {
    const Vec3 slip = touch::slip_velocity(model, data, press);
    if (slip.norm() >= options_.slip_threshold) {
      const Eigen::Matrix3d to_body = rotation.transpose();
      add_slip(to_body * slip, to_body * press.normal, press.normal_force, shares, out);
    }
  }
  if (!pressure_.empty()) add_pressure(press.normal_force, shares);
}

void Touch::add_force(const Vec3& world, const Eigen::Matrix3d& rotation, Span<const Share> shares, float* out) const {
  const Vec3 force = options_.frame == TouchFrame::kWorld ? world : Vec3(rotation.transpose() * world);
  const bool in_skin = options_.frame == TouchFrame::kSkin;
  for (const Share& share : shares) {
    const auto sensor = static_cast<std::size_t>(share.sensor);
    const Vec3 own = share.weight * (in_skin ? Vec3(skin_->sensors()[sensor].frame * force) : force);
    Eigen::Map<Eigen::Vector3f>{out + 3 * sensor} += own.cast<float>();
  }
}

// The contact's tangent plane is tilted into that of the sensor, so that around a corner no speed is lost.
void Touch::add_slip(const Vec3& slip, const Vec3& normal, double normal_force, Span<const Share> shares,
                     float* out) const {
  for (const Share& share : shares) {
    const auto sensor = static_cast<std::size_t>(share.sensor);
    const Eigen::Matrix3d& frame = skin_->sensors()[sensor].frame;
    const Vec3 tilted = Eigen::Quaterniond::FromTwoVectors(normal, frame.row(0).transpose()) * slip;
    const Eigen::Vector2d own = share.weight * normal_force * (frame.bottomRows<2>() * tilted);
    Eigen::Map<Eigen::Vector2f>{out + 2 * sensor} += own.cast<float>();
  }
}

void Touch::add_pressure(double normal_force, Span<const Share> shares) {
  for (const Share& share : shares) {
    double& pressure = pressure_[static_cast<std::size_t>(share.sensor)];
    if (pressure == 0 && share.weight > 0) pressed_.push_back(share.sensor);
    pressure += share.weight * normal_force;
  }
}

void Touch::finish_means(std::uint8_t* block) {
  float* slip = output(block, slip_);
  float* use = output(block, friction_use_);
  for (const int sensor : pressed_) {
    const auto i = static_cast<std::size_t>(sensor);
    const float scale = static_cast<float>(1 / pressure_[i]);
    if (slip != nullptr) {
      slip[2 * i] *= scale;
      slip[2 * i + 1] *= scale;
    }
    if (use != nullptr) use[i] = std::min(use[i] * scale, 1.0F);
    pressure_[i] = 0;
  }
  pressed_.clear();
}

std::unique_ptr<observation::Sense> make_skin_sense(const mjModel& model, const body::Body& body,
                                                    std::shared_ptr<const touch::Skin> skin,
                                                    const TouchOptions& options, touch::ThingsPtr things, double tick) {
  auto rattle = std::make_unique<touch::Rattle>(skin->sensors().size(), things->all.size(), tick);
  auto nerves = std::make_unique<Nerves>(model, body, std::move(skin), options, std::move(things), *rattle, tick);
  auto sense = std::make_unique<observation::Signals>(observation::Share::kTouch, nerves->signals(options.wanted));
  sense->keep(std::move(rattle));
  sense->keep(std::move(nerves));
  return sense;
}

}  // namespace mimo::senses
