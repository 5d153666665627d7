// Where the eyes look, and making them look at a point.

#include "body/face.h"

#include <algorithm>

#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "env/world.h"
#include "mimo/experimental.h"

namespace mimo::capi {
namespace {

// The world of an agent that there is.
template <typename Env>
auto& world_of(Env* env, std::size_t agent) {
  auto& world = open(env).world();
  check_agent(world.agents(), agent);
  return world;
}

Eigen::Vector3d point_from(const double* point) {
  require(point != nullptr, "point is NULL");
  check_finite(point, 3, "point");
  return {point[0], point[1], point[2]};
}

bool turns_head(std::int32_t how) {
  check_choice(how, MIMO_LOOK_EYES, MIMO_LOOK_HEAD, "how");
  return how == MIMO_LOOK_HEAD;
}

void write_sightline(const body::Sightline& from, double (&position)[3], double (&direction)[3]) {
  std::copy_n(from.position.data(), 3, position);
  std::copy_n(from.direction.data(), 3, direction);
}

void check_capacity(std::size_t capacity, std::size_t needed, bool wanted) {
  check_length<double>(capacity, "capacity");
  if (wanted && capacity < needed) {
    fail(Status::kBufferTooSmall, "capacity is {}, but there are {} joints", capacity, needed);
  }
}

void write_angles(const body::Look& look, std::int32_t* joints, double* angles) {
  for (std::size_t i = 0; i < look.angles.size(); ++i) {
    if (joints != nullptr) joints[i] = look.angles[i].joint;
    if (angles != nullptr) angles[i] = look.angles[i].angle;
  }
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
    const body::Gaze now = env::gaze(world_of(env, agent), agent);
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
    env::World& world = world_of(env, agent);
    const bool turn_head = turns_head(how);
    const std::size_t found = body::Eyes::joints(turn_head);
    check_capacity(capacity, found, joints != nullptr || angles != nullptr);
    const body::Look wanted = env::look(world, agent, point_from(point), turn_head);
    if (count != nullptr) *count = found;
    write_angles(wanted, joints, angles);
    write_errors(wanted, errors);
  });
}

mimo_status mimo_env_look_at(mimo_env* env, size_t agent, const double* point, int32_t how, double* errors) noexcept {
  return guard(env, [&] {
    env::World& world = world_of(env, agent);
    write_errors(env::look_at(world, agent, point_from(point), turns_head(how)), errors);
  });
}

}  // extern "C"

using namespace mimo;

extern "C" {

const char* mimo_face_name(size_t index) noexcept {
  return index < body::kFaces.size() ? body::kFaces[index] : nullptr;
}

}  // extern "C"
