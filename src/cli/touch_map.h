// A map of the skin, unfolded: the body as it stands straight, from the front and from the back.
#pragma once

#include <string>

#include "cli/picture.h"
#include "cli/skin.h"

namespace cli {

// From the front an infant's right is on the left, from the back its left is. Has sensors to draw only where the agent
// of that name ("" for a sole one) has them.
class TouchMap {
 public:
  TouchMap(const mimo::Env& env, const std::string& agent);

  bool possible() const { return !skin_.sensors().empty(); }
  ColorPicture draw(const mimo::Block& block) const;

 private:
  struct Place {
    double across, up;  // m
    bool front;
  };

  Skin skin_;
  std::vector<Place> places_;
};

}  // namespace cli
