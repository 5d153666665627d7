// The sense of touch: the forces of the last physics step's contacts at the sensors, and what the nerves of the skin
// report.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "base/header.h"
#include "body/body.h"
#include "observation/sense.h"
#include "senses/touch/felt.h"

namespace mimo::senses {

// What an agent's touch is made of: the inner form of the touch fields of mimo_agent_config.

// Of the header.
enum class TouchFrame : std::int32_t { kBody = MIMO_FRAME_BODY, kWorld = MIMO_FRAME_WORLD, kSkin = MIMO_FRAME_SKIN };

// What contacts give, and the rest: what nerves tell.
constexpr std::uint32_t kContactOutputs =
    MIMO_TOUCH_FORCE | MIMO_TOUCH_NORMAL_FORCE | MIMO_TOUCH_SLIP | MIMO_TOUCH_FRICTION_USE;
constexpr std::uint32_t kSkinNerves = header::kTouch & ~kContactOutputs;

struct TouchOptions {
  std::uint32_t wanted = MIMO_TOUCH_FORCE;  // MIMO_TOUCH_ bits
  touch::Response response = touch::Response::kLinear;
  TouchFrame frame = TouchFrame::kBody;
  double scale = 1;                       // divides the spacing of every body that has none of its own below
  double slip_threshold = 0.005;          // m/s; slower slip counts as none
  std::optional<double> everywhere;       // m; in place of the usual spacings
  std::map<std::string, double> spacing;  // m, by body name without the agent's prefix; 0: no skin there
};

// Throws Status::kInvalidArgument for outputs that exclude each other.
void check_outputs(const TouchOptions& options);

// The sense of touch: what the sensors of the skin feel of the contacts of the last physics step.

// The bodies that get a skin, with their spacings. Throws for a body by name that is not there or cannot be touched.
std::vector<touch::BodySpacing> spacings(const mjModel& model, const body::Body& body, const TouchOptions& options);

class Touch : public observation::Sense {
 public:
  Touch(std::shared_ptr<const touch::Skin> skin, const TouchOptions& options);
  observation::Share share() const override { return observation::Share::kTouch; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

  const touch::Skin& skin() const { return *skin_; }

 private:
  static constexpr int kNone = -1;
  int add(std::uint32_t bit, const char* name, std::size_t width, const char* unit, const char* frame);
  float* output(std::uint8_t* block, int field) const {
    return field == kNone ? nullptr : at<float>(block, static_cast<std::size_t>(field));
  }

  void feel(const mjModel& model, const mjData& data, const touch::Press& press, std::uint8_t* block);
  void add_force(const touch::Vec3& world, const Eigen::Matrix3d& rotation, Span<const touch::Share> shares,
                 float* out) const;
  // Slip and the contact's outward normal are in the body's frame.
  void add_slip(const touch::Vec3& slip, const touch::Vec3& normal, double normal_force,
                Span<const touch::Share> shares, float* out) const;
  void add_pressure(double normal_force, Span<const touch::Share> shares);
  void finish_means(std::uint8_t* block);

  TouchOptions options_;
  std::shared_ptr<const touch::Skin> skin_;
  touch::Spread spread_;
  int force_, normal_force_, slip_, friction_use_;  // fields

  // Slip and friction use are means over the contacts of a sensor, weighted by how hard they press.
  std::vector<double> pressure_;  // by sensor, N; zero between writes
  std::vector<int> pressed_;      // the sensors where it is not
};

// What the nerves of a skin tell: touch afferents, temperature, pain. Beside what Touch says of forces.

// `tick` is the time from one advance of its process to the next, s.
std::unique_ptr<observation::Sense> make_skin_sense(const mjModel& model, const body::Body& body,
                                                    std::shared_ptr<const touch::Skin> skin,
                                                    const TouchOptions& options, touch::ThingsPtr things, double tick);

}  // namespace mimo::senses
