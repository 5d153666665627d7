// Room on mjData's own stack, as MuJoCo's solvers take it: too little is MuJoCo's error.
#pragma once

#include <mujoco/mujoco.h>

#include <type_traits>

namespace mimo::engine {

// Uninitialised; whoever keeps data.pstack and puts it back gives it free.
template <typename T>
T* take(mjData& data, int count) {
  static_assert(std::is_trivial_v<T> && alignof(T) <= alignof(mjtNum));
  const auto bytes = static_cast<std::size_t>(count) * sizeof(T);
  return reinterpret_cast<T*>(mj_stackAlloc(&data, static_cast<int>((bytes + sizeof(mjtNum) - 1) / sizeof(mjtNum))));
}

}  // namespace mimo::engine
