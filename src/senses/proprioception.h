// Where the joints are, how fast they move, what pulls at them, and how near they are to their limits.
#pragma once

#include "body/body.h"
#include "senses/sense.h"

namespace mimo::senses {

struct ProprioceptionOptions {
  bool position = true;
  bool velocity = true;
  bool torque = true;  // three axes at each joint sensor
  bool limit = true;
  bool actuation = true;
  bool joint_torque = false;       // about each joint's own axis
  double limit_threshold = 0.035;  // rad
  bool position_control = false;   // actuation means target angles then
  bool effort = false;             // what the commands cost; the actuation writes it
};

class Proprioception : public Sense {
 public:
  Proprioception(const mjModel& model, body::Body body, const ProprioceptionOptions& options);
  Part part() const override { return Part::kProprioception; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  using Writer = void (Proprioception::*)(const mjModel&, const mjData&, float*) const;

  void add(Field field, Writer writer);
  void write_position(const mjModel& model, const mjData& data, float* out) const;
  void write_velocity(const mjModel& model, const mjData& data, float* out) const;
  void write_torque(const mjModel& model, const mjData& data, float* out) const;
  void write_limit(const mjModel& model, const mjData& data, float* out) const;
  void write_control(const mjModel& model, const mjData& data, float* out) const;
  void write_motor_torque(const mjModel& model, const mjData& data, float* out) const;
  void write_actuator_force(const mjModel& model, const mjData& data, float* out) const;
  void write_target(const mjModel& model, const mjData& data, float* out) const;
  void write_joint_torque(const mjModel& model, const mjData& data, float* out) const;

  body::Body body_;
  std::vector<int> locks_;  // of the motors' joints, under position control
  double threshold_;
  std::vector<Writer> writers_;  // one per field
};

}  // namespace mimo::senses
