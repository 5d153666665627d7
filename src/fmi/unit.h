// A running unit of FMI: a world behind variables with numbers, whatever the version of FMI.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "fmi/variables.h"

namespace cli {

constexpr char kUnitArguments[] = "mimo.txt";  // in resources: the token, then the options, a word a line

using Bytes = std::vector<std::uint8_t>;

class RunningUnit {
 public:
  // Throws a Failure where the unit is not that of the token.
  RunningUnit(const std::string& resources, const std::string& token);

  // FMI's modes. Each throws a Failure where it may not follow.
  void initialize(double start_time);
  void start();
  void step(double time, double seconds);
  void terminate() { mode_ = kTerminated; }
  void reset();

  const Variable& variable(std::uint32_t number, const char* type, int version) const;
  // All elements of a variable.
  template <typename T>
  void get(const Variable& it, T* values) const;
  const std::uint8_t* picture(const Variable& it) const { return block_.data() + it.place; }
  void set_action(const Variable& it, double value);
  void set_seed(std::uint64_t seed);

  Bytes save() const;
  void load(const Bytes& state);

  double experiment_start = 0;  // s, as FMI 2 sets it up before the unit is initialized

  // What a function of FMI does with its error.
  std::function<void(const std::string&)> log;

 private:
  enum Mode { kMade, kInitializing, kStepping, kTerminated };

  void begin();

  UnitOptions options_;
  mimo::Env env_{nullptr};
  std::vector<Variable> variables_;
  mimo::Block block_;
  mimo::Results results_;
  std::vector<float> actions_, rest_;
  double step_ = 0, time_ = 0;
  std::uint64_t seed_ = 0;
  bool fresh_ = false;  // the world was reset with that seed
  Mode mode_ = kMade;
};

}  // namespace cli
