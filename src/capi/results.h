// What calls on worlds take and return: the caller's memory, starts of episodes, results of steps, reports of loading.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "capi/check.h"
#include "capi/structs.h"
#include "env/state.h"
#include "env/world.h"
#include "observation/observer.h"

namespace mimo::capi {

// The caller's memory for observations.

// The start of a caller's block that is long enough, or null.
inline std::uint8_t* block_of(const observation::Layout& layout, void* block, std::size_t bytes) {
  auto* start = static_cast<std::uint8_t*>(block);
  check_buffer(start, bytes, layout.bytes(), "block");
  return start;
}

// What loading a state tells.

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

// How an episode starts, of worlds and of attached senses.

// None: the random numbers go on.
struct Seed {
  std::optional<std::uint64_t> value;
  const std::uint64_t* pointer() const { return value ? &*value : nullptr; }
};

inline Seed seed_of(const mimo_reset_config& ours) {
  check_flag(ours.seeded, "seeded");
  require(ours.seeded != 0 || ours.seed == 0, "seed is {}, but seeded is 0, expected 1", ours.seed);
  if (ours.seeded == 0) return {};
  return {ours.seed};
}

// What the results of a step have in common, of one world and of many.

// For as many agents and terms as there are in all worlds.
template <typename Theirs>
void check_results(const Theirs& theirs, std::size_t agents, std::size_t terms) {
  check_reserved(theirs.reserved, "results: reserved");
  check_length<double>(theirs.agent_count, "results: agent_count");
  check_length<double>(theirs.term_count, "results: term_count");
  const bool any = theirs.reward != nullptr || theirs.terminated != nullptr || theirs.truncated != nullptr ||
                   theirs.outcome != nullptr;
  if (any && theirs.agent_count < agents) {
    fail(Status::kBufferTooSmall, "results: agent_count is {}, but reward, terminated, truncated and outcome need {}",
         theirs.agent_count, agents);
  }
  if (theirs.terms != nullptr && theirs.term_count < terms) {
    fail(Status::kBufferTooSmall, "results: term_count is {}, but terms needs {}", theirs.term_count, terms);
  }
}

// None where the caller wants none.
template <typename T>
Span<T> optional(T* values, std::size_t count) {
  return values == nullptr ? Span<T>() : Span<T>(values, count);
}

inline env::Results results_of(const env::World& world, const mimo_env_results* results) {
  if (results == nullptr) return {};
  const mimo_env_results theirs = read_struct(results, "results");
  const std::size_t agents = world.agents().size(), terms = world.term_count();
  check_results(theirs, agents, terms);
  return {optional(theirs.reward, agents), optional(theirs.terminated, agents), optional(theirs.truncated, agents),
          optional(theirs.outcome, agents), optional(theirs.terms, terms)};
}

}  // namespace mimo::capi
