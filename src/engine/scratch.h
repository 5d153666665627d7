// Memory that a world needs only while it is stepped, which all worlds of the process share.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <cstddef>

namespace mimo::engine {

struct ScratchMemory;

// While this lives, mjData has its stack and the constraints' Jacobian in memory that no other thread uses. Neither
// outlives a call of MuJoCo that computes a step or a part of one. So worlds that a thread steps in turn need one such
// memory among them, and find it in the processor's cache. Their own stays as large as it is, for all other calls, but
// the system gives no memory for what no code touches. Where there is no memory, they use their own, and so do worlds
// that need more than 16 MB: what one thread needed once stays.
//
// On MuJoCo 4 this does nothing: one arena has the stack and what a step leaves behind.
class Scratch {
 public:
  Scratch(const mjModel& model, mjData& data);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

 private:
  [[maybe_unused]] mjData& data_;
  [[maybe_unused]] ScratchMemory* memory_ = nullptr;
  [[maybe_unused]] double* own_stack_ = nullptr;
  [[maybe_unused]] std::ptrdiff_t moved_ = 0;  // the Jacobian, by bytes
};

// As long as this lives, so many more threads step at the same time: what they need is there before their first step.
class ScratchSupply {
 public:
  explicit ScratchSupply(std::size_t threads);
  ~ScratchSupply();
  ScratchSupply(const ScratchSupply&) = delete;
  ScratchSupply& operator=(const ScratchSupply&) = delete;

  // For worlds of this model.
  void provide(const mjModel& model, const mjData& data) const;

 private:
  std::size_t threads_;
};

}  // namespace mimo::engine
