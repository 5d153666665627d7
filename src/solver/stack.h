// Room on mjData's own stack, as MuJoCo's solvers take it: too little is MuJoCo's error.
#pragma once

#include <type_traits>

#include "compat/mujoco.h"

namespace mimo::solver {

// Uninitialised; whoever marks the stack before and releases it gives it free.
template <typename T>
T* take(mjData& data, int count) {
  static_assert(std::is_trivial_v<T> && alignof(T) <= alignof(mjtNum));
  return reinterpret_cast<T*>(compat::take_stack(data, static_cast<std::size_t>(count) * sizeof(T)));
}

}  // namespace mimo::solver
