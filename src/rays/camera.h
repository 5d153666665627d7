// Eyes: where rays come from and what is seen from there, by the picture's camera and by way of its one reflecting
// solid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rays/solids.h"

namespace mimo::rays {

// Where rays come from, and what is seen from there.
//
// All eyes are alike: the camera, its mirror image behind a reflecting plane, and each light that casts shadows.
// What an eye sees is parametrised by two numbers x, y (slopes right and up over depth); in the frame of a solid,
// a ray from the eye is then  o + t (a + x bx + y by)  with t the depth along the eye's axis. For the parallel rays
// of a directional light the roles are swapped: it is the origin that varies,  (a + x bx + y by) + t o.

constexpr double kEverywhere = 1e9;  // beyond all bounds

enum class Rays : std::int32_t { kPerspective, kParallel, kAround };

// A solid as an eye sees it.
struct Aspect {
  std::array<float, 3> o{}, a{}, bx{}, by{};
  float left = 0, right = 0, bottom = 0, top = 0;  // bounds of x and y
  float nearest = 0;                               // and of depth
  std::int32_t solid = 0;
  std::int32_t self = -2;  // among the camera's aspects, the one of the same solid
  // Rays with facing[0] + x facing[1] + y facing[2] > 0 lead away from the solid.
  std::array<float, 3> facing{};
  // For rays around a point: the bounding sphere, seen from the eye.
  std::array<float, 3> center{};
  float radius = 0;
};

struct Eye {
  Rays rays = Rays::kPerspective;
  Vec position = Vec::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  // columns: x (right), y (up), z (forward)
  double reach = 0;                                // nothing farther is of interest
  double wide = 0, high = 0;                       // nor anything outside of -wide..wide and -high..high
  std::vector<Aspect> aspects;                     // room for all solids; the first `count` count, nearest first
  int count = 0;

  // Adds a solid to what is seen, unless all of it is behind the eye or too far away.
  void look_at(const Solid& solid, int index, double near_depth);
};

// The eye that the picture is taken with.

struct Camera : Eye {
  float near_plane = 0;
  float far_plane = 0;
  std::vector<int> seen;         // index of a solid's aspect, -2 if it has none
  std::vector<int> transparent;  // aspects of transparent solids in the order in which they are drawn: the first ones
  int transparent_count = 0;

  // For so many solids at most.
  explicit Camera(std::size_t most);

  void place(const render::Air& air, const render::View& view, double aspect_ratio);
  void look_around(const Solids& solids);
};

// What the one reflecting solid shows.

struct Mirror {
  int solid = -1;  // that reflects, -1 for none
  float reflectance = 0;
  Eye eye;  // the mirrored camera's

  // For so many solids at most.
  explicit Mirror(std::size_t most);

  void hold(const Solids& solids, const Camera& camera, bool reflections);
};

}  // namespace mimo::rays
