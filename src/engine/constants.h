// What MuJoCo's compiler derives from the masses of bodies, found out anew for masses that one world has changed.
#pragma once

#include <mujoco/mjmodel.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace mimo::engine {

// A model like the given one whose masses can be tried out: its numbers are its own, what is only drawn stays shared.
// MuJoCo writes to more than masses when it derives, and none of that may reach a model that worlds share.
class Constants {
 public:
  explicit Constants(const mjModel& model);

  // The inertia grows along.
  void scale_mass(int body, double mass);
  // Throws Status::kInvalidArgument for masses with which there is no calculating.
  void derive();
  // Copies masses and what follows from them to a model whose arrays may be written to.
  void copy_to(mjModel& model) const;

 private:
  mjModel model_;
  std::vector<std::unique_ptr<std::uint8_t[]>> arrays_;
};

}  // namespace mimo::engine
