// Small models in which one thing goes wrong, and what to do with them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "compat/mujoco.h"
#include "engine/physics.h"
#include "support/numbers.h"

namespace mimo::test {

// A floor and layers of 16 spheres of 5 cm, a centimetre above it and beside each other; `extra` goes to the top.
inline std::string pile(int spheres, const std::string& extra) {
  std::string bodies;
  for (int i = 0; i < spheres; ++i) {
    const double x = 0.11 * (i % 4), y = 0.11 * (i / 4 % 4), z = 0.06 + 0.11 * (i / 16);
    bodies += format("<body pos='{} {} {}'><freejoint/><geom size='0.05' mass='0.1'/></body>", x, y, z);
  }
  return "<mujoco><option timestep='0.005'/>" + extra + "<worldbody><geom type='plane' size='1 1 .1'/>" + bodies +
         "</worldbody></mujoco>";
}

// Room for a few contacts only. MuJoCo 4 has no limit of their number, but of their bytes.
#if MIMO_MUJOCO_4
constexpr const char* kFewContacts = "<size memory='10K'/>";
#else
constexpr const char* kFewContacts = "<size nconmax='5'/>";
#endif

// One sphere on a slide that a spring pulls at.
inline std::string spring(double stiffness) {
  return format(
      "<mujoco><option timestep='0.005'/><worldbody><body><joint name='slide' type='slide' axis='1 0 0' "
      "springref='0.1' "
      "stiffness='{}'/><geom size='0.05' mass='0.1'/></body></worldbody><actuator><motor name='motor' joint='slide'/>"
      "</actuator></mujoco>",
      stiffness);
}

inline engine::ModelPtr compiled(const std::string& xml) { return engine::compile(xml, {}, {}); }

// State after each of `steps` steps, one behind the other.
inline std::vector<double> trajectory(engine::Physics& physics, int steps) {
  std::vector<double> states;
  for (int i = 0; i < steps; ++i) {
    physics.step(1);
    const mjData& data = physics.data();
    states.insert(states.end(), data.qpos, data.qpos + physics.model().nq);
    states.insert(states.end(), data.qvel, data.qvel + physics.model().nv);
  }
  return states;
}

// The error that a call throws; fails the test if it throws none.
template <typename Call>
Error error_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return Error(Status::kOk, "");
}

inline ::testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "\"" << text << "\" does not contain \"" << part << "\"";
}

template <typename Call>
void expect_error(Status status, const std::string& part, Call&& call) {
  const Error error = error_of(call);
  EXPECT_EQ(static_cast<int>(error.status()), static_cast<int>(status)) << error.message();
  EXPECT_TRUE(contains(error.message(), part));
  EXPECT_EQ(error.message().find('\n'), std::string::npos) << "more than one line: " << error.message();
}

}  // namespace mimo::test
