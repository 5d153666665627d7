// What each sensor of a skin feels of the contacts of one physics step, before any receptor makes anything of it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "senses/touch/press.h"
#include "senses/touch/spread.h"
#include "senses/touch/things.h"

namespace mimo::senses::touch {

struct Feeling {
  double normal = 0;                                  // N
  Eigen::Vector2d tangent = Eigen::Vector2d::Zero();  // along the sensor's two tangents, N
  double sliding = 0;                                 // m/s, weighted by the normal force: divide by it
  double lift = 0;                                    // m/s, with which friction of what slides may throw it off
  double strongest = 0;                               // normal force of the contact that presses it most, N
  int other = -1;                                     // and the thing that does, as things.h counts
};

// Where something presses: the nearest sensor, and how hard in Pa.
struct Prick {
  int sensor;
  double pressure;
};

class Felt {
 public:
  // What is not wanted, slip and pricks, costs nothing. Slip below the threshold (m/s) is that of friction that holds.
  struct Wanted {
    bool sliding, pricks;
    double slip_threshold;
  };
  Felt(const Skin& skin, Response response, Wanted wanted, const Things& things);

  void take_in(const mjModel& model, const mjData& data);
  // Those that feel anything now, each once.
  const std::vector<int>& sensors() const { return sensors_; }
  const Feeling& of(int sensor) const { return feelings_[static_cast<std::size_t>(sensor)]; }
  const std::vector<Prick>& pricks() const { return pricks_; }

 private:
  void add(const mjModel& model, const mjData& data, const Press& press);

  const Skin& skin_;
  const Things& things_;
  Spread spread_;
  Wanted wanted_;
  std::vector<Feeling> feelings_;
  std::vector<int> sensors_;
  std::vector<Prick> pricks_;
};

}  // namespace mimo::senses::touch
