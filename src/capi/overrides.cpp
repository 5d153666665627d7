// What differs from world to world.
#include <Eigen/Core>

#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "env/locks.h"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_lock(mimo_env* env, int32_t joint, double angle) noexcept {
  return guard(env, [&] { env::lock(open(env).world, joint, angle); });
}

mimo_status mimo_env_unlock(mimo_env* env, int32_t joint) noexcept {
  return guard(env, [&] { env::unlock(open(env).world, joint); });
}

mimo_status mimo_env_lock_state(const mimo_env* env, int32_t joint, uint8_t* locked, double* angle) noexcept {
  return guard(env, [&] {
    const env::Lock lock = env::lock_state(open(env).world, joint);
    if (locked != nullptr) *locked = lock.locked ? 1 : 0;
    if (angle != nullptr) *angle = lock.angle;
  });
}

mimo_status mimo_env_set_gravity(mimo_env* env, double x, double y, double z) noexcept {
  return guard(env, [&] {
    engine::Physics& physics = open(env).world.physics();
    const double xyz[3] = {x, y, z};
    check_finite(xyz, 3, "gravity");
    physics.set_gravity({x, y, z});
  });
}

mimo_status mimo_env_gravity(const mimo_env* env, double* xyz, size_t count) noexcept {
  return guard(env, [&] {
    const engine::Physics& physics = open(env).world.physics();
    check_buffer(&out(xyz, "xyz"), count, 3, "xyz");
    Eigen::Map<Eigen::Vector3d>{xyz} = physics.gravity();
  });
}

}  // extern "C"
