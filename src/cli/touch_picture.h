// Pictures of touch: sensors as points, what they feel as colours and arrows.
#pragma once

#include <vector>

#include "picture.h"

namespace cli {

class TouchPicture {
 public:
  // Needs touch/force of the agents, with three components in the frame of the body.
  explicit TouchPicture(const mimo::Env& env);

  // Whether the world has sensors to draw.
  bool possible() const { return !sensors_.empty(); }
  std::size_t sensors() const { return sensors_.size(); }

  // The rest needs possible().
  // The view that `config` describes, with the touch in the block over it. The block belongs to the world's state.
  ColorPicture draw(mimo::Env& env, const mimo_picture_config& config, const mimo::Block& block);

  // A view of what is felt most; the overview where nothing is felt.
  mimo_picture_config close_up(mimo::Env& env, const mimo::Block& block) const;

 private:
  using Vector = mimo::Vector;
  struct Sensor {
    std::int32_t body;
    Vector position, normal;  // body frame
    std::size_t force;        // where it stands in the block
  };
  // A sensor as it is in the world.
  struct Feeling {
    Vector position, normal, force;
  };

  void add(const mimo::Layout& layout, const mimo_field& field);
  static std::size_t strongest_of(const std::vector<Feeling>& felt);
  std::vector<Feeling> feelings(const mimo::Env& env, const mimo::Block& block) const;

  std::vector<Sensor> sensors_;
};

}  // namespace cli
