#include "senses/touch/touch.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/bits.h"
#include "base/fail.h"
#include "base/format.h"
#include "base/header.h"
#include "base/names.h"
#include "engine/custom.h"
#include "senses/touch/spacing.h"

namespace mimo::senses {

using touch::Press;
using touch::Share;
using touch::Side;
using touch::Vec3;

namespace {

using engine::Kind;

static_assert((MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE | MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE | kSkinNerves) ==
              header::kTouch);

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
    fail(Status::kNotFound, "touch: no body \"{}\" that could have a skin; there are: {}", name, join(there, ", "));
  }
}

// The spacing that a body has if nobody says otherwise: what the model's document says in the tuple "mimo:touch", where
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

}  // namespace

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

}  // namespace mimo::senses
