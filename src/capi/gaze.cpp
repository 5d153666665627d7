// Where the eyes look, and making them look at a point.
#include <algorithm>

#include "body/eyes.h"
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

body::Eyes eyes_of(const env::World& world, std::size_t agent) {
  check_agent(world.agents(), agent);
  return body::Eyes(world.model(), world.agents()[agent].body);
}

// How an agent looks at a point from the pose that the world is in now.
body::Look look(env::World& world, std::size_t agent, const double* point, bool turn_head) {
  const body::Eyes eyes = eyes_of(world, agent);
  require(point != nullptr, "point is NULL");
  check_finite(point, 3, "point");
  world.physics().update_poses();
  return eyes.look_at(world.model(), world.data(), {point[0], point[1], point[2]}, turn_head);
}

bool turns_head(std::int32_t how) {
  require(how == MIMO_LOOK_EYES || how == MIMO_LOOK_HEAD, "how is {}, expected MIMO_LOOK_EYES or MIMO_LOOK_HEAD", how);
  return how == MIMO_LOOK_HEAD;
}

void write_sightline(const body::Sightline& from, double (&position)[3], double (&direction)[3]) {
  std::copy_n(from.position.data(), 3, position);
  std::copy_n(from.direction.data(), 3, direction);
}

void write_errors(const body::Look& look, double* errors) {
  if (errors != nullptr) std::copy(look.errors.begin(), look.errors.end(), errors);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_gaze(const mimo_env* env, size_t agent, mimo_gaze* gaze) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world;
    const body::Gaze now = eyes_of(world, agent).gaze(world.data());
    mimo_gaze ours{};
    write_sightline(now.left, ours.left_position, ours.left_direction);
    write_sightline(now.right, ours.right_position, ours.right_direction);
    ours.vergence = now.vergence;
    ours.meets = now.meets ? 1 : 0;
    std::copy_n(now.point.data(), 3, ours.point);
    ours.miss = now.miss;
    write_described(gaze, ours, "gaze");
  });
}

mimo_status mimo_env_look_angles(mimo_env* env, size_t agent, const double* point, int32_t how, int32_t* joints,
                                 double* angles, size_t capacity, size_t* count, double* errors) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world;
    const bool turn_head = turns_head(how);
    const std::size_t found = body::Eyes::joints(turn_head);
    check_length<double>(capacity, "capacity");
    if ((joints != nullptr || angles != nullptr) && capacity < found) {
      fail(Status::kBufferTooSmall, "capacity is {}, but there are {} joints", capacity, found);
    }
    const body::Look wanted = look(world, agent, point, turn_head);
    for (std::size_t i = 0; i < found; ++i) {
      if (joints != nullptr) joints[i] = wanted.angles[i].joint;
      if (angles != nullptr) angles[i] = wanted.angles[i].angle;
    }
    if (count != nullptr) *count = found;
    write_errors(wanted, errors);
  });
}

mimo_status mimo_env_look_at(mimo_env* env, size_t agent, const double* point, int32_t how, double* errors) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world;
    const body::Look wanted = look(world, agent, point, turns_head(how));
    for (const body::JointAngle& joint : wanted.angles) world.physics().data().qpos[joint.qpos] = joint.angle;
    world.physics().update_poses();
    write_errors(wanted, errors);
  });
}

}  // extern "C"
