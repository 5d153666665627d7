// Recorded states: JSON objects that map joint names to numbers.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "repository_paths.h"
#include "support/numbers.h"
#include "support/scenes.h"

namespace mimo::test {

using Json = nlohmann::json;

inline Json read_json(const std::string& name) {
  const std::string path = std::string(MIMO_TEST_DATA) + "/" + name;
  std::ifstream file(path);
  Json content = Json::parse(file, nullptr, false);
  EXPECT_FALSE(content.is_discarded()) << path << " cannot be read";
  return content;
}

// What the MuJoCo that runs does by itself, recorded with it.
inline Json recorded_motion(const std::string& name) { return read_json(MIMO_MUJOCO_4 ? "mujoco4/" + name : name); }

// Every joint of the model must be in the recording.
inline void set_positions(const mjModel& model, const Json& recorded, double* qpos) {
  for (int joint = 0; joint < model.njnt; ++joint) {
    const std::vector<double> values = recorded.at(joint_key(model, joint));
    ASSERT_EQ(static_cast<int>(values.size()), position_width(model, joint));
    std::copy(values.begin(), values.end(), qpos + model.jnt_qposadr[joint]);
  }
}

inline void expect_positions(const mjModel& model, const Json& recorded, const double* qpos,
                             const Tolerance& tolerance) {
  ASSERT_EQ(static_cast<int>(recorded.size()), model.njnt);
  for (int joint = 0; joint < model.njnt; ++joint) {
    const std::string key = joint_key(model, joint);
    EXPECT_TRUE(close(recorded.at(key), qpos + model.jnt_qposadr[joint], tolerance)) << "position of " << key;
  }
}

// Anything that has one number a degree of freedom: velocities, forces, the inertia's diagonal.
inline void expect_dofs(const char* what, const mjModel& model, const Json& recorded, const double* actual,
                        const Tolerance& tolerance = {}) {
  ASSERT_EQ(static_cast<int>(recorded.size()), model.njnt);
  for (int joint = 0; joint < model.njnt; ++joint) {
    const std::string key = joint_key(model, joint);
    const std::vector<double> expected = recorded.at(key);
    ASSERT_EQ(static_cast<int>(expected.size()), velocity_width(model, joint)) << key;
    EXPECT_TRUE(close(expected, actual + model.jnt_dofadr[joint], tolerance)) << what << " of " << key;
  }
}

}  // namespace mimo::test
