// Pictures of touch: sensors in a view or on an unfolded map of the skin, what they feel as colours and arrows.
#pragma once

#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "cli/picture.h"

namespace cli {

// Touch sensors of agents: where they are, and what they feel.

constexpr double kNothing = 1e-4;  // N

mimo::Vector sum(const mimo::Vector& a, const mimo::Vector& b, double scale = 1);
double norm(const mimo::Vector& v);
mimo::Vector rotated(const double* q, const mimo::Vector& v);  // by a unit quaternion w x y z

class Skin {
 public:
  // What an agent feels with as touch/force, three components in the frame of the body; "" for that of all agents.
  Skin(const mimo::Env& env, const std::string& fields_of);

  struct Sensor {
    std::int32_t body;
    mimo::Vector position, normal;  // body frame
    std::size_t force;              // where it stands in the block
  };
  // A sensor as it is in the world.
  struct Feeling {
    mimo::Vector position, normal, force;
  };

  const std::vector<Sensor>& sensors() const { return sensors_; }
  // The block belongs to the world's state.
  std::vector<Feeling> feelings(const mimo::Env& env, const mimo::Block& block) const;
  double force(std::size_t sensor, const mimo::Block& block) const;  // N

 private:
  void add(const mimo::Layout& layout, const mimo_field& field);
  mimo::Vector components(std::size_t sensor, const mimo::Block& block) const;

  std::vector<Sensor> sensors_;
};

// A map of the skin, unfolded: the body as it stands straight, from the front and from the back.

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

// Pictures of touch: sensors as points, what they feel as colours and arrows.

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
