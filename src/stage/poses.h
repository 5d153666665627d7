// Where everything of a stage is, in one picture.
#pragma once

#include <array>
#include <vector>

#include "base/span.h"
#include "rays/solids.h"
#include "rays/surfaces.h"
#include "render/stage.h"
#include "stage/parts.h"

namespace mimo::stage {

// Throws Status::kInvalidArgument for what does not fit the parts or is not finite. `which` is told.
void check_poses(const Parts& parts, const mimo_stage_poses& poses, std::size_t which);

// Brings poses into the form that rays take: for one picture at a time, in memory of its own.
class Mover {
 public:
  explicit Mover(const Parts& parts);

  // Others with the same surfaces take the parts' place.
  void adopt(const Parts& parts);
  // Poses that were checked. They outlive what follows.
  void take(const mimo_stage_poses& poses);
  // What of them a view shows, beside geoms and sites.
  void gather_extras(const mimo_stage_view& view);

  // The stage with what is there: parts that have no poses are left out.
  render::Stage shown(const mimo_stage_view& view) const;
  render::Poses places() const;
  Span<const rays::Extra> extras() const { return extras_; }
  // Id and type of what a picture's segmentation names by one number.
  std::array<int, 2> object(int id) const;

 private:
  void add_surfaces(unsigned groups);
  void add_tendons(unsigned groups);
  void add_given();
  void add(const rays::Extra& extra, std::array<int, 2> object);

  const Parts* parts_;
  render::Stage all_;
  const mimo_stage_poses* poses_ = nullptr;
  std::vector<double> geom_rotations_, site_rotations_;  // from quaternions
  std::vector<rays::Draped> draped_;
  rays::DrawnVertices vertices_;
  std::vector<rays::Extra> extras_;
  std::vector<std::array<int, 2>> objects_;  // of the extras
};

}  // namespace mimo::stage
