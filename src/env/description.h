// What a world, or attached senses, observe, act with and are rewarded for, as those see it who use them.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "env/attached.h"
#include "env/world.h"

namespace mimo::env {

// In seconds after the end of a step.
struct Interval {
  double start, end;
};

struct Action {
  std::string name;
  const char* unit;
  std::size_t agent;
  double low, high;
};

struct RewardTerm {
  std::string name;
  std::size_t agent;
};

// It outlives what it describes: worlds of other models may come after.
struct Description {
  std::size_t block_bytes = 0;
  std::vector<observation::Field> fields;
  std::vector<SkinPtr> skins;   // of the fields' receptors
  std::vector<Interval> times;  // by field
  std::vector<observation::Lateness> delays;
  double period = 0;  // seconds from one step to the next
  std::size_t agents = 0;
  std::vector<Action> actions;
  std::vector<RewardTerm> terms;
};

Description describe(const World& world);
Description describe(const Attached& attached);

// Throws Status::kInvalidArgument, with the first difference, where blocks, actions or terms of the two are not alike:
// in anything but bounds and the places of receptors.
void check_alike(const Description& expected, const Description& other);

// A description that threads read while its owner changes it: what they read is from before a change, or from after it.
class LiveDescription {
 public:
  // Changes wait while it lives.
  class Reading {
   public:
    Reading(std::mutex& mutex, const Description& description) : lock_(mutex), description_(description) {}
    const Description& operator*() const { return description_; }
    const Description* operator->() const { return &description_; }

   private:
    std::lock_guard<std::mutex> lock_;
    const Description& description_;
  };

  explicit LiveDescription(Description description = {}) : description_(std::move(description)) {}

  Reading read() const { return {mutex_, description_}; }
  // Before anybody reads it.
  void begin_as(const Description& description) { description_ = description; }
  // Of another that is alike. Names and shapes stay where they are: pointers to them have been given away.
  void widen(const Description& other) noexcept;  // the wider bounds of both
  void adopt(Description&& other) noexcept;       // its bounds, receptors and times

 private:
  mutable std::mutex mutex_;
  Description description_;
};

}  // namespace mimo::env
