// The limits of a world's senses: what is done to an observation after it was made. Without any it costs nothing.
#pragma once

#include <string>
#include <vector>

#include "observation/layout.h"
#include "observation/limited_field.h"

namespace mimo::observation {

// Limits of a field, or of all below a path.
struct PathLimits {
  std::string path;  // "touch", "proprioception/velocity"
  Limits limits;
};

class LimitedSenses {
 public:
  // `prefix` is that of the agent's fields, `step` how long one is in seconds. Where several concern a field, the last
  // one counts. Throws Status::kNotFound for a path that leads to no field.
  void add(const Layout& layout, const std::string& prefix, const std::vector<PathLimits>& paths, double step);
  // After all were added.
  void make_room(const Layout& layout);

  // How many steps late a field of the layout is.
  std::size_t delay(const Field& field) const;
  // Whether senses are late: then every step has to be sensed, into the room here if nobody gives any.
  bool late() const { return !room_.empty(); }
  std::uint8_t* room() { return room_.data(); }

  // What was just sensed, in an episode's first observation, in one of a step, or in between, which changes nothing
  // here. Noise follows from `episode`, the seed of its noise, and the step.
  void begin(std::uint8_t* block, std::uint64_t episode);
  void step(std::uint8_t* block, std::uint64_t episode, std::uint64_t step);
  void look(std::uint8_t* block, std::uint64_t episode, std::uint64_t step);

  // What is late, for a state. This object outlives them, and nothing is added to it any more.
  void list(std::vector<Section>& sections);

 private:
  void weaken(std::uint8_t* block, std::uint64_t episode, std::uint64_t step);

  std::vector<LimitedField> fields_;
  std::vector<std::uint8_t> room_;
};

}  // namespace mimo::observation
