// A sense that the user has written as C functions: its table, copied, from the program or from a shared library.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "env/options.h"
#include "mimo/experimental.h"

namespace mimo::capi {

struct SensePlan {
  SensePlan() = default;
  ~SensePlan();
  SensePlan(const SensePlan&) = delete;
  SensePlan& operator=(const SensePlan&) = delete;

  std::string whose;                // "the sense \"ct\"", for messages
  std::shared_ptr<void> library;    // that holds the functions; null: the program
  std::string path;                 // of that library
  mimo_sense table{};               // without what it pointed to: name, description, parameters
  mimo_sense_release_fn release{};  // once the table has been taken
  env::OwnSense described;          // what makes it, with its name and parameters
};
using SensePlanPtr = std::shared_ptr<SensePlan>;

// They throw for what is no table of a sense. The plan does not release the user's pointer before take_over.
SensePlanPtr sense_plan(const mimo_sense* sense);
SensePlanPtr load_sense_plan(const char* path);
// To a scene's agent, as the calls of a recording do.
void add_recorded_sense(mimo_scene* scene, std::size_t agent, const SensePlanPtr& plan);
// From now on it belongs to the library.
void take_over(SensePlan& plan);

mimo_sense empty_sense();

}  // namespace mimo::capi
