// What the two labyrinths of a head tell of its motion: canals, otolith organs, and where up is.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "engine/present.h"
#include "observation/sense.h"
#include "receptors/labyrinth.h"
#include "senses/vestibular.h"

namespace mimo::senses {

// Of MIMO_VESTIBULAR_, what nerves tell of the head's motion in Hz, and an estimate of gravity.
constexpr std::uint32_t kLabyrinth = MIMO_VESTIBULAR_CANALS | MIMO_VESTIBULAR_OTOLITHS | MIMO_VESTIBULAR_GRAVITY;

class Labyrinth : public observation::Process {
 public:
  // What carries it, and where its otolith organs are in that frame: left and right.
  struct Head {
    engine::Place place;
    const char* frame;
    std::array<Eigen::Vector3d, receptors::kSides> ears = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  };

  Labyrinth(const Head& head, double tick);
  // Refer to this object, which stays where it is.
  std::vector<observation::Signal> signals(std::uint32_t wanted) const;

 private:
  void rest(const mjModel& model, const mjData& data) override;
  void go_on(const mjModel& model, const mjData& data) override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

  Head head_;
  receptors::Canals canals_;
  std::array<receptors::Maculae, receptors::kSides> maculae_;
  receptors::GravityEstimate gravity_;
};

// Of an infant: its largest sphere is the head, and the labyrinths lie in it.
Labyrinth::Head head_with_ears(const mjModel& model, int head);

}  // namespace mimo::senses
