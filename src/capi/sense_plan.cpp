#include "capi/sense_plan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/fail.h"
#include "base/format.h"
#include "capi/check.h"
#include "capi/handed.h"
#include "capi/own_code.h"
#include "capi/own_sense.h"
#include "capi/structs.h"
#include "recording/system.h"

namespace mimo::capi {
namespace {

constexpr std::size_t kLongestName = 63;
constexpr const char* kEntry = "mimo_sense_entry";

using Parameter = env::OwnSense::Parameter;

bool is_plain(const std::string& name) {
  return !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

void check_name(const char* name, const std::string& argument) {
  require(name != nullptr, "{} is NULL, expected one", argument);
  require(is_plain(name), "{} is \"{}\", expected up to {} lower-case letters, digits and _", argument, name,
          kLongestName);
}

Parameter parameter_of(const mimo_parameter& theirs, const std::string& argument) {
  check_name(theirs.name, argument + ": name");
  require(std::isfinite(theirs.low) && std::isfinite(theirs.high) && theirs.low <= theirs.high,
          "{}: low is {} and high is {}, expected finite numbers with low <= high", argument, theirs.low, theirs.high);
  require_between(theirs.standard, theirs.low, theirs.high, (argument + ": standard").c_str());
  return {theirs.name, text(theirs.description), theirs.standard, theirs.low, theirs.high};
}

std::vector<Parameter> parameters_of(const mimo_sense& sense) {
  std::vector<Parameter> all;
  for_each_of(sense.parameters, sense.parameter_count, "sense: parameters",
              [&](const mimo_parameter& theirs, const std::string& argument) {
                Parameter parameter = parameter_of(theirs, argument);
                for (const Parameter& other : all) {
                  require(other.name != parameter.name, "sense: there are two parameters \"{}\"", parameter.name);
                }
                all.push_back(std::move(parameter));
              });
  return all;
}

void check_functions(const mimo_sense& sense) {
  check_flag(sense.host_fills, "sense: host_fills");
  require(sense.open != nullptr, "sense: open is NULL");
  if (sense.host_fills == 0) {
    require(sense.write != nullptr, "sense: write is NULL, expected a function unless host_fills is 1");
    return;
  }
  require(sense.reset == nullptr && sense.advance == nullptr && sense.write == nullptr,
          "sense: host_fills is 1, and reset, advance or write is set, expected only open and close");
}

// Of another version of the rules even the table may be another one.
void check_version(const mimo_sense& sense) {
  if (sense.interface_version == MIMO_SENSE_INTERFACE) return;
  fail(Status::kUnsupported, "sense: interface_version is {}, but this library knows {} (MIMO_SENSE_INTERFACE)",
       sense.interface_version, MIMO_SENSE_INTERFACE);
}

SensePlanPtr plan_of(const mimo_sense& sense) {
  check_version(sense);
  check_name(sense.name, "sense: name");
  check_functions(sense);
  auto plan = std::make_shared<SensePlan>();
  plan->whose = format("the sense \"{}\"", sense.name);
  plan->table = sense;
  plan->table.name = plan->table.description = nullptr;
  plan->table.parameters = nullptr;
  plan->described.name = sense.name;
  plan->described.parameters = parameters_of(sense);
  for (const Parameter& parameter : plan->described.parameters) plan->described.values.push_back(parameter.standard);
  return plan;
}

std::shared_ptr<void> open_library(const std::string& path) {
  const std::string whole = std::filesystem::absolute(std::filesystem::u8path(path)).u8string();
  void* const library = recording::open_library(whole.c_str());
  if (library == nullptr) {
    fail(Status::kFile, "path is \"{}\", expected a shared library with a sense: {}", path,
         as_line(recording::why_not_opened()));
  }
  return {library, recording::close_library};
}

// The table as the library fills it; of a newer interface it may be longer than ours.
SensePlanPtr plan_from(const std::shared_ptr<void>& library, const std::string& path) {
  const auto entry = reinterpret_cast<mimo_sense_entry_fn>(recording::symbol_of(library.get(), kEntry));
  if (entry == nullptr) {
    fail(Status::kFile, "path is \"{}\", expected a shared library with a sense: it exports no {}", path, kEntry);
  }
  Handed<mimo_sense> filled;
  call_out(path, kEntry, [&] { return entry(filled.get()); });
  check_version(*filled);
  require(filled.newer_at() == 0, "sense: it has members beyond its first {} bytes, which this library does not know",
          sizeof(mimo_sense));
  SensePlanPtr plan = plan_of(*filled);
  plan->library = library;
  plan->path = path;
  return plan;
}

}  // namespace

SensePlan::~SensePlan() {
  if (release == nullptr) return;
  try {
    release(table.user);
  } catch (...) {  // the user's own affair
  }
}

mimo_sense empty_sense() {
  mimo_sense sense{};
  sense.struct_size = sizeof sense;
  return sense;
}

SensePlanPtr sense_plan(const mimo_sense* sense) {
  require(sense != nullptr, "sense is NULL");
  return plan_of(read_struct(sense, "sense"));
}

SensePlanPtr load_sense_plan(const char* path) {
  const std::string where = text(path);
  require(!where.empty(), "path is {}, expected that of a shared library", path == nullptr ? "NULL" : "\"\"");
  const std::shared_ptr<void> library = open_library(where);
  try {
    return plan_from(library, where);
  } catch (const Error& error) {
    if (error.message().find(where) != std::string::npos) throw;
    throw Error(error.status(), where + ": " + error.message());
  }
}

void take_over(SensePlan& plan) { plan.release = plan.table.release; }

}  // namespace mimo::capi
