// Touch sensors of agents: where they are, and what they feel.
#pragma once

#include <mimo/mimo.hpp>
#include <string>
#include <vector>

namespace cli {

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

}  // namespace cli
