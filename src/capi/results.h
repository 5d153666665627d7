// What the results of a step have in common, of one world and of many.
#pragma once

#include "capi/check.h"
#include "capi/structs.h"
#include "env/world.h"

namespace mimo::capi {

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
