// The head's accelerometer and gyroscope and all torque sensors of an infant held still (vestibular.json).
//
// The recording was made with MuJoCo 2.3.7. At rest only statics count, and they are the same in both versions: our
// 2.2.2 repeats all numbers to 4e-13 Nm and 1e-10 m/s^2, so they are compared like any other recording, with a floor of
// 1e-11 for what is as good as zero. The recorded gyroscope is zero to 6e-14 rad/s.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "support/recording.h"

namespace mimo::test {
namespace {

using engine::Kind;

// On MuJoCo 4, which has a recording of its own, our solver ends elsewhere within its tolerance than MuJoCo's.
constexpr Tolerance kAtRest = {kRelative, MIMO_MUJOCO_4 ? 1e-7 : 1e-11};

const double* sensor(const engine::Physics& physics, const std::string& name) {
  const mjModel& model = physics.model();
  return physics.data().sensordata + model.sensor_adr[engine::find_or_fail(model, Kind::kSensor, name)];
}

TEST(GoldenVestibular, AtRest) {
  const Json recordings = recorded_motion("vestibular.json");
  ASSERT_EQ(recordings.size(), 2u);
  for (const Json& recorded : recordings) {
    SCOPED_TRACE(recorded.at("orientation").get<std::string>());
    engine::Physics physics(held_infant(recorded.at("root_quat_wxyz").get<std::array<double, 4>>()), {});
    physics.step(1500);
    EXPECT_TRUE(close(recorded.at("acc"), sensor(physics, "vestibular_acc"), kAtRest));
    EXPECT_TRUE(close(recorded.at("gyro"), sensor(physics, "vestibular_gyro"), kAtRest));
    const Json& torques = recorded.at("torque_sensors");
    ASSERT_EQ(torques.size(), 21u);
    for (const auto& [name, torque] : torques.items()) {
      EXPECT_TRUE(close(torque, sensor(physics, name), kAtRest)) << name;
    }
  }
}

}  // namespace
}  // namespace mimo::test
