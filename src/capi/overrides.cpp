// What differs from world to world.
#include <algorithm>
#include <cmath>

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
    const mjModel& model = open(env).world.model();
    const int lock = env::lock_of(model, joint);
    if (locked != nullptr) *locked = model.eq_active[lock] != 0 ? 1 : 0;
    if (angle != nullptr) *angle = engine::lock_angle(model, lock);
  });
}

mimo_status mimo_env_set_gravity(mimo_env* env, double x, double y, double z) noexcept {
  return guard(env, [&] {
    engine::Physics& physics = open(env).world.physics();
    const double xyz[3] = {x, y, z};
    check_finite(xyz, 3, "gravity");
    std::copy(xyz, xyz + 3, physics.gravity());
  });
}

mimo_status mimo_env_gravity(const mimo_env* env, double* xyz, size_t count) noexcept {
  return guard(env, [&] {
    const mjModel& model = open(env).world.model();
    check_buffer(&out(xyz, "xyz"), count, 3, "xyz");
    std::copy_n(model.opt.gravity, 3, xyz);
  });
}

}  // extern "C"
