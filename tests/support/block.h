// An observation block and its fields by name.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "env/world.h"

namespace mimo::test {

class Observation {
 public:
  explicit Observation(const env::World& world) : world_(&world), bytes_(world.layout().bytes()) {}

  std::uint8_t* data() { return bytes_.data(); }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  std::vector<float> operator[](const std::string& name) const {
    const observation::Field& field = find(name);
    std::vector<float> values(field.count());
    std::memcpy(values.data(), bytes_.data() + field.offset, field.bytes());
    return values;
  }

  // The element with this label, "robot:left_elbow".
  float at(const std::string& name, const std::string& label) const {
    const observation::Field& field = find(name);
    for (std::size_t i = 0; i < field.count(); ++i) {
      if (label == field.label(i)) return (*this)[name][i];
    }
    ADD_FAILURE() << name << " has no element " << label;
    return 0;
  }

 private:
  const observation::Field& find(const std::string& name) const {
    for (std::size_t i = 0; i < world_->layout().size(); ++i) {
      if (world_->layout()[i].name == name) return world_->layout()[i];
    }
    ADD_FAILURE() << "no field " << name;
    return world_->layout()[0];
  }

  const env::World* world_;
  std::vector<std::uint8_t> bytes_;
};

// Actions that differ from step to step, the same in every run.
inline std::vector<float> some_actions(const env::World& world, int step) {
  std::vector<float> actions(world.action_size());
  for (std::size_t i = 0; i < actions.size(); ++i) {
    actions[i] = static_cast<float>(static_cast<int>(i * 7 + static_cast<std::size_t>(step) * 3) % 11 - 5) / 5;
  }
  return actions;
}

}  // namespace mimo::test
