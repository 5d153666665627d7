#include "access/access.h"

#include <algorithm>

#include "base/fail.h"
#include "engine/present.h"
#include "env/world.h"

namespace mimo::access {
namespace {

template <typename T>
void read_all(const Source& source, const Quantity& quantity, const Ids& ids, Span<T> values) {
  static_assert(env::kLargestGoal >= kWidest);
  double computed[env::kLargestGoal];
  T* to = values.data();
  Element one{source, 0};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    one.id = ids[i];
    const double* from = computed;
    if (quantity.stored != nullptr) {
      from = quantity.stored(one);
    } else {
      quantity.compute(one, computed);
    }
    to = std::transform(from, from + width(quantity, one.model, one.world, one.id), to,
                        [](double value) { return static_cast<T>(value); });
  }
}

template <typename T>
void read_at(const env::World& world, const Quantity& quantity, const Ids& ids, bool now, Span<T> values) {
  if (now) require_known_now(quantity);
  if (!now || quantity.moment == Moment::kAlways) {
    return read_all({world.model(), world.data(), &world}, quantity, ids, values);
  }
  engine::Present present;
  read_all({world.model(), present.of(world.physics()), &world}, quantity, ids, values);
}

}  // namespace

void read(const Source& source, const Quantity& quantity, const Ids& ids, Span<double> values) {
  read_all(source, quantity, ids, values);
}

void get(const env::World& world, const Quantity& quantity, const Ids& ids, bool now, Span<double> values) {
  read_at(world, quantity, ids, now, values);
}

void get(const env::World& world, const Quantity& quantity, const Ids& ids, bool now, Span<float> values) {
  read_at(world, quantity, ids, now, values);
}

void require_known_now(const Quantity& quantity) {
  require(quantity.moment != Moment::kStep,
          "quantity is {}, which only physics steps compute, so it has no MIMO_NOW; mimo_env_observe computes all such "
          "values now",
          quantity.constant);
}

void require_writable(const Quantity& quantity) {
  require(quantity.writing != Writing::kNever, "quantity is {}, which can only be read", quantity.constant);
}

void check_settable(const env::World& world, const Quantity& quantity, const Ids& ids, Span<const double> values) {
  require_writable(quantity);
  check_finite(values.data(), values.size(), "values");
  if (quantity.check == nullptr) return;
  const double* from = values.data();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    quantity.check(world, ids[i], from);
    from += width(quantity, world.model(), &world, ids[i]);
  }
}

void set(env::World& world, const Quantity& quantity, const Ids& ids, Span<const double> values) {
  // Values that survive a reset stay writable in a failed world, so that the caller can undo what broke it.
  if (quantity.writing != Writing::kWorld) std::as_const(world).physics().require_usable();
  check_settable(world, quantity, ids, values);
  engine::Physics& physics = world.physics();
  if (quantity.write_all != nullptr) return quantity.write_all(world, ids, values);
  const double* from = values.data();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    quantity.write(world, ids[i], from);
    from += width(quantity, physics.model(), &world, ids[i]);
  }
  if (quantity.moves && !physics.failed()) physics.update_poses();
}

}  // namespace mimo::access
