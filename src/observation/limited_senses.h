// The limits of a world's senses: what is done to an observation after it was made. Without any it costs nothing.
#pragma once

#include <string>
#include <vector>

#include "base/random.h"
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
  // `prefix` is that of the agent's fields. Where several concern a field, the last one counts. Throws
  // Status::kNotFound for a path that leads to no field.
  void add(const Layout& layout, const std::string& prefix, const std::vector<PathLimits>& paths);
  // After all were added.
  void make_room(const Layout& layout);

  // Whether senses are late: then every step has to be sensed, into the room here if nobody gives any.
  bool late() const { return !room_.empty(); }
  std::uint8_t* room() { return room_.data(); }

  // A new episode: its noise follows from the world's random numbers, without using any up.
  void start(const Random& random);
  // What was just sensed, in an episode's first observation, in one of a step, or in between.
  void begin(std::uint8_t* block);
  void step(std::uint8_t* block, std::uint64_t step);
  void look(std::uint8_t* block, std::uint64_t step);

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  void weaken(std::uint8_t* block, std::uint64_t step);

  std::vector<LimitedField> fields_;
  std::vector<std::uint8_t> room_;
  std::uint64_t seed_ = 0;
};

}  // namespace mimo::observation
