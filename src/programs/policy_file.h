// The file of a learned policy, read and checked: docs/guide/policies.md. Nothing of worlds.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

struct PolicyFile {
  struct Field {
    std::string name;
    std::size_t count;
  };
  struct Layer {
    std::size_t rows, columns;
    std::vector<float> weights, bias;  // weights column after column: sums of all rows then grow side by side
  };
  // Pulls each action's joint to the goal that the network gives.
  struct Reflex {
    float stiffness, damping;         // of the action's unit, per rad and per rad/s
    std::vector<std::string> joints;  // labels, one for each action
    std::vector<float> start;         // rad; goals are counted from there
  };

  std::string scene;          // in which it was learned; "" where the file does not say
  std::optional<double> age;  // months, at which it is watched
  bool delays = false;        // it was learned with nerves of the infant's age
  double step_seconds = 0;    // 0: any
  double hold_s = 0;          // an output of the network holds so long; 0: one step
  float clip = 10;
  std::vector<Field> fields;
  std::vector<double> clock_s;  // periods of the clock, which is read after the fields
  std::vector<std::string> actions;
  std::vector<float> mean, deviation;
  std::vector<Layer> layers;
  std::optional<Reflex> reflex;
};

// What a file says, for a message: cut between two letters where it is long.
std::string shortened(std::string text);

[[noreturn]] void refuse_policy(const std::string& file, const std::string& why);

// Throws a Failure for a file that cannot be read or is no policy.
PolicyFile read_policy(const std::string& file);

}  // namespace cli
