// A head with two ears, and one impact as they hear it. It follows from its beginning alone, so that there is little to
// remember, and no error grows.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "base/span.h"
#include "sound/impact.h"
#include "sound/sphere.h"

namespace mimo::hearing {

// A head that hears: a ball with an ear on each side.

constexpr std::size_t kEars = 2;  // left, right
using Ways = std::array<sound::Way, kEars>;

// Where a head is, in the world.
struct Head {
  double radius = 0;                        // m
  Eigen::Vector3d middle;                   // of the ball
  std::array<Eigen::Vector3d, kEars> ears;  // from there, of length 1
};

// Of an infant's head that looks along x of its frame, with z up: ears lie 100 degrees to both sides, as in adults.
std::array<Eigen::Vector3d, kEars> ears_of_frame();

Ways ways_to(const Head& head, const Eigen::Vector3d& place);

// What a blow sends out.
struct Blow {
  Eigen::Vector3d place;  // in the world
  double onset = 0;       // samples since the episode began, and parts of one
  sound::Click click;     // its scale is 0 where there is none
  sound::Ringing ringing;
};

class Voice {
 public:
  Voice() = default;
  Voice(const Blow& blow, const Ways& ways, double rate);

  bool alive(std::int64_t now) const { return now < end_; }
  // About the energy that is still to come, to find the voice that is missed least.
  double remains(std::int64_t now) const;
  // Adds what an ear hears of it from this sample on.
  void add(std::size_t ear, std::int64_t now, Span<float> out);

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  void add_click(std::size_t ear, std::int64_t first, std::int64_t now, Span<float> out);
  void add_ringing(std::size_t ear, std::int64_t first, std::int64_t now, Span<float> out) const;
  void prepare();
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit);

  double rate_ = 1;                    // samples a second
  std::int64_t end_ = -1;              // no ear hears it from here on
  std::array<double, kEars> start_{};  // when it reaches an ear, in samples
  // The click, the way to each ear, and the filter there, which goes on.
  sound::Click click_;
  Ways ways_;
  std::array<sound::Filter, kEars> filter_{};
  // Modes: radians and nepers a sample; what each ear hears of them.
  std::uint64_t modes_ = 0;
  std::array<double, sound::kModes> turn_{}, decay_{};
  std::array<std::array<double, sound::kModes>, kEars> amplitude_{}, phase_{};
  // What follows from them: a sample's decay, cosine and sine.
  std::array<double, sound::kModes> kept_{}, cosine_{}, sine_{};
};

}  // namespace mimo::hearing
