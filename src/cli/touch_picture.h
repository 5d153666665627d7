// Pictures of touch: sensors as points, what they feel as colours and arrows.
#pragma once

#include <vector>

#include "cli/picture.h"
#include "cli/skin.h"

namespace cli {

class TouchPicture {
 public:
  // Needs touch/force of the agents, with three components in the frame of the body.
  explicit TouchPicture(const mimo::Env& env) : skin_(env, "") {}

  // Whether the world has sensors to draw.
  bool possible() const { return !skin_.sensors().empty(); }
  std::size_t sensors() const { return skin_.sensors().size(); }

  // The rest needs possible().
  // The view that `config` describes, with the touch in the block over it. The block belongs to the world's state. What
  // of the scenery hides what is felt, such as the floor from below, is not drawn.
  ColorPicture draw(mimo::Env& env, const mimo_picture_config& config, const mimo::Block& block);

  // A view of what is felt, from the side on which it is; the overview where nothing is felt.
  mimo_picture_config close_up(mimo::Env& env, const mimo::Block& block) const;

 private:
  Skin skin_;
};

}  // namespace cli
