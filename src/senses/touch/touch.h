// The sense of touch: what the sensors of the skin feel of the contacts of the last physics step.
#pragma once

#include <memory>

#include "body/body.h"
#include "observation/sense.h"
#include "senses/touch/options.h"
#include "senses/touch/press.h"

namespace mimo::senses {

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

}  // namespace mimo::senses
