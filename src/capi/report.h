// What loading a state tells.
#pragma once

#include <utility>

#include "capi/structs.h"
#include "env/state.h"

namespace mimo::capi {

// Loads, and fills the report where there is one; what is wrong with it is said before anything changes. `kept` is the
// handle's, whose strings the report shows.
template <typename Load>
void load_and_report(mimo_load_report* report, env::LoadReport& kept, Load&& load) {
  if (report != nullptr) check_struct_size<mimo_load_report>(report->struct_size, "report");
  env::LoadReport loaded = load();
  kept = std::move(loaded);
  if (report == nullptr) return;
  mimo_load_report ours{};
  ours.fresh = kept.fresh;
  ours.ignored = kept.ignored;
  ours.fresh_names = kept.fresh_names.c_str();
  ours.ignored_names = kept.ignored_names.c_str();
  write_described(report, ours, "report");
}

}  // namespace mimo::capi
