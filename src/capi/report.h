// What loading a state tells.
#pragma once

#include <string>

#include "base/format.h"
#include "capi/structs.h"
#include "env/state.h"

namespace mimo::capi {

// The strings of a handle's last report.
struct LoadedNames {
  std::string fresh, ignored;
};

// Loads, and fills the report where there is one; what is wrong with it is said before anything changes.
template <typename Load>
void load_and_report(mimo_load_report* report, LoadedNames& names, Load&& load) {
  if (report != nullptr) check_struct_size<mimo_load_report>(report->struct_size, "report");
  const env::LoadReport loaded = load();
  if (report == nullptr) return;
  names = {join(loaded.fresh, ", "), join(loaded.ignored, ", ")};
  mimo_load_report ours{};
  ours.fresh = loaded.fresh.size();
  ours.ignored = loaded.ignored.size();
  ours.fresh_names = names.fresh.c_str();
  ours.ignored_names = names.ignored.c_str();
  write_described(report, ours, "report");
}

}  // namespace mimo::capi
