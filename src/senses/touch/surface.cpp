#include "senses/touch/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/functions.h"
#include "base/numbers.h"
#include "base/random.h"
#include "senses/touch/shape.h"
#include "senses/touch/skin.h"

namespace mimo::senses::touch {
namespace {

using Cell = std::array<int, 3>;

class BoxGrid {
 public:
  BoxGrid(const Vec3& half, double spacing) : half_(half) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double cells = std::ceil(2 * half[static_cast<Eigen::Index>(axis)] / spacing);
      count_[axis] = std::max(2, static_cast<int>(cells));
    }
    number_points();
  }

  Surface surface() const {
    Surface surface;
    for (const Cell& cell : cells_) surface.points.push_back({position(cell), sides(cell).normalized()});
    for (std::size_t i = 0; i < cells_.size(); ++i) connect(static_cast<int>(i), surface);
    return surface;
  }

 private:
  // -1, 0 or 1 by axis: which faces the cell lies on. Points on edges and corners look between their faces.
  Vec3 sides(const Cell& cell) const {
    Vec3 side;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      side[static_cast<Eigen::Index>(axis)] = (cell[axis] == count_[axis] - 1) - (cell[axis] == 0);
    }
    return side;
  }

  Vec3 position(const Cell& cell) const {
    Vec3 place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = static_cast<double>(cell[axis]) / (count_[axis] - 1);
      const double half = half_[static_cast<Eigen::Index>(axis)];
      place[static_cast<Eigen::Index>(axis)] = -half + 2 * half * share;
    }
    return place;
  }

  // The cells in the order of their points. A grid line's inner cells are jumped over, not tried: there are many.
  void number_points() {
    for (int x = 0; x < count_[0]; ++x) {
      for (int y = 0; y < count_[1]; ++y) {
        const bool inner = sides({x, y, 1}).head<2>().isZero();
        for (int z = 0; z < count_[2]; z += inner ? count_[2] - 1 : 1) cells_.push_back({x, y, z});
      }
    }
  }

  int index(const Cell& cell) const {
    const auto found = std::lower_bound(cells_.begin(), cells_.end(), cell);
    return found != cells_.end() && *found == cell ? static_cast<int>(found - cells_.begin()) : -1;
  }

  // Neighbours, also diagonal ones, that share a face with the point.
  void connect(int point, Surface& surface) const {
    const Cell& cell = cells_[static_cast<std::size_t>(point)];
    for (int step = 0; step < 27; ++step) {
      const Cell other{cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1};
      if (!(cell < other)) continue;
      const int neighbour = index(other);
      const bool same_face = neighbour >= 0 && (sides(cell).cwiseProduct(sides(other)).array() > 0).any();
      if (same_face) surface.edges.emplace_back(point, neighbour);
    }
  }

  Vec3 half_;
  std::array<int, 3> count_{};
  std::vector<Cell> cells_;  // ascending
};

// So near may two points be, in spacings: then there is about one for each square of a spacing.
constexpr double kNearest = 0.77;
constexpr double kDarts = 24;  // for each such square

// The two sides of a thin part look opposite ways; they do not push each other's points away.
bool same_side(const SurfacePoint& one, const SurfacePoint& other) { return one.normal.dot(other.normal) > -0.5; }

class Strewn {
 public:
  explicit Strewn(double apart) : apart_(apart) {}

  // Keeps the point, unless one that was kept is too near.
  void offer(const SurfacePoint& point) {
    const Cell cell = cell_of(point.position);
    for (int step = 0; step < 27; ++step) {
      const auto found = cells_.find(key({cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1}));
      if (found == cells_.end()) continue;
      for (const int kept : found->second) {
        const SurfacePoint& other = points_[static_cast<std::size_t>(kept)];
        if ((other.position - point.position).norm() < apart_ && same_side(other, point)) return;
      }
    }
    cells_[key(cell)].push_back(static_cast<int>(points_.size()));
    points_.push_back(point);
  }

  std::vector<SurfacePoint> take() { return std::move(points_); }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Vec3& place) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(axis)] / apart_));
    }
    return cell;
  }

  // Cells that share a key are merely looked through together.
  static std::uint64_t key(const Cell& cell) {
    std::uint64_t key = 0;
    for (const std::int64_t part : cell) key = key * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(part);
    return key;
  }

  double apart_;
  std::vector<SurfacePoint> points_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

// Places on a surface, one as likely as the other.
class Darts {
 public:
  explicit Darts(const Hull& hull) : hull_(hull) {
    double sum = 0;
    for (const Triangle& triangle : hull.triangles) up_to_.push_back(sum += triangle.area);
  }

  SurfacePoint next() {
    const auto at = std::lower_bound(up_to_.begin(), up_to_.end(), random_.uniform() * up_to_.back());
    const Triangle& triangle = hull_.triangles[static_cast<std::size_t>(at - up_to_.begin())];
    double first = random_.uniform(), second = random_.uniform();
    if (first + second > 1) {
      first = 1 - first;
      second = 1 - second;
    }
    return {triangle.corner + first * triangle.first + second * triangle.second, triangle.normal};
  }

 private:
  const Hull& hull_;
  std::vector<double> up_to_;
  Random random_{1};
};

void link(Surface& surface, double apart) {
  std::vector<Vec3> places;
  for (const SurfacePoint& point : surface.points) places.push_back(point.position);
  const PointTree tree(places, 0);
  for (int i = 0; i < static_cast<int>(places.size()); ++i) {
    const SurfacePoint& own = surface.points[static_cast<std::size_t>(i)];
    tree.within(own.position, 2 * apart, [&](int other, double) {
      const bool towards = own.normal.dot(surface.points[static_cast<std::size_t>(other)].normal) > -0.1;
      if (other > i && towards) surface.edges.emplace_back(i, other);
    });
  }
}

struct Ring {
  double radius, z;
  double normal_radial, normal_z;
  int count;  // 1 is a pole
};

// Half to even, whatever the host's rounding mode.
double round_even(double value) {
  const double floor = std::floor(value);
  const double rest = value - floor;
  const bool up = rest > 0.5 || (rest == 0.5 && std::fmod(floor, 2) != 0);
  return up ? floor + 1 : floor;
}

int count_around(double radius, double spacing) { return static_cast<int>(std::ceil(2 * kPi * radius / spacing)); }

// An angle that hits the ring above or below between two points connects to both.
void connect_rings(const Ring& upper, int upper_first, const Ring& lower, int lower_first, Surface& surface) {
  for (int i = 0; i < upper.count; ++i) {
    const double place = static_cast<double>(i) * lower.count / upper.count;
    const int before = static_cast<int>(place);
    surface.edges.emplace_back(upper_first + i, lower_first + before % lower.count);
    if (lower.count > 1) surface.edges.emplace_back(upper_first + i, lower_first + (before + 1) % lower.count);
  }
}

void connect_around(const Ring& ring, int first, Surface& surface) {
  if (ring.count == 2) surface.edges.emplace_back(first, first + 1);
  if (ring.count < 3) return;
  for (int i = 0; i < ring.count; ++i) surface.edges.emplace_back(first + i, first + (i + 1) % ring.count);
}

// The few points of a sphere's last ring are neighbours across the pole.
void connect_across(const Ring& ring, int first, Surface& surface) {
  for (int i = 0; i < ring.count; ++i) {
    for (int j = i + 2; j < ring.count; ++j) surface.edges.emplace_back(first + i, first + j);
  }
}

void add_points(const Ring& ring, Surface& surface) {
  for (int i = 0; i < ring.count; ++i) {
    const double angle = 2 * kPi * i / ring.count;
    const Vec3 radial(fixed::cos(angle), fixed::sin(angle), 0);
    surface.points.push_back(
        {ring.radius * radial + ring.z * Vec3::UnitZ(), ring.normal_radial * radial + ring.normal_z * Vec3::UnitZ()});
  }
}

Surface surface_of(const std::vector<Ring>& rings) {
  Surface surface;
  int above = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const int first = static_cast<int>(surface.points.size());
    add_points(rings[i], surface);
    connect_around(rings[i], first, surface);
    if (i == 0 || i + 1 == rings.size()) connect_across(rings[i], first, surface);
    if (i > 0) {
      connect_rings(rings[i - 1], above, rings[i], first, surface);
      connect_rings(rings[i], first, rings[i - 1], above, surface);
    }
    above = first;
  }
  return surface;
}

// The lower half of a shape that is the same upside down; `rings` holds the upper one.
void mirror(std::vector<Ring>& rings, std::size_t count) {
  for (std::size_t i = count; i-- > 0;) {
    Ring ring = rings[i];
    ring.z = -ring.z;
    ring.normal_z = -ring.normal_z;
    rings.push_back(ring);
  }
}

// The straight side from z = half_length down to -half_length.
void add_side(std::vector<Ring>& rings, double radius, double half_length, double spacing, int count) {
  const int steps = static_cast<int>(std::ceil(2 * half_length / spacing));
  for (int i = 0; i <= steps; ++i) {
    const double z = steps == 0 ? 0 : half_length - 2 * half_length * i / steps;
    rings.push_back({radius, z, 1, 0, count});
  }
}

struct Entry {
  std::string_view part;
  double spacing;  // m
};

// Two-point discrimination distances, the same for left and right, as the original sets them (the paper's section
// IV-D).
constexpr Entry kTable[] = {
    {"toes", 0.010},
    {"big_toe", 0.010},
    {"foot", 0.015},
    {"lower_leg", 0.038},
    {"upper_leg", 0.027},
    {"hip", 0.025},
    {"lower_body", 0.025},
    {"upper_body", 0.030},
    {"head", 0.013},
    {"eye", 1.0},
    {"upper_arm", 0.024},
    {"lower_arm", 0.024},
    {"hand", 0.007},
    // Mitten hands.
    {"fingers", 0.002},
    // Hands with five fingers.
    {"lfmetacarpal", 0.007},
    {"ffknuckle", 0.004},
    {"mfknuckle", 0.004},
    {"rfknuckle", 0.004},
    {"lfknuckle", 0.004},
    {"thbase", 0.004},
    {"ffmiddle", 0.004},
    {"mfmiddle", 0.004},
    {"rfmiddle", 0.004},
    {"lfmiddle", 0.004},
    {"thhub", 0.004},
    {"ffdistal", 0.002},
    {"mfdistal", 0.002},
    {"rfdistal", 0.002},
    {"lfdistal", 0.002},
    {"thdistal", 0.002},
};

std::string_view without_side(std::string_view name) {
  for (const std::string_view side : {"left_", "right_"}) {
    if (name.substr(0, side.size()) == side) return name.substr(side.size());
  }
  return name;
}

}  // namespace

double area(const OuterShape& shape) {
  const Vec3& s = shape.size;
  switch (shape.form) {
    case OuterShape::Form::kSphere: return 4 * kPi * s.x() * s.x();
    case OuterShape::Form::kCapsule: return 4 * kPi * s.x() * (s.x() + s.y());
    case OuterShape::Form::kCylinder: return 2 * kPi * s.x() * (s.x() + 2 * s.y());
    case OuterShape::Form::kBox: return 8 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
    case OuterShape::Form::kEllipsoid: return 4 * kPi * s.maxCoeff() * s.maxCoeff();
    case OuterShape::Form::kMesh: return shape.hull->area();
    case OuterShape::Form::kNone: break;
  }
  return 0;
}

Surface single_point() { return {{{Vec3::Zero(), Vec3::Zero()}}, {}}; }

double expected_points(const OuterShape& shape, double spacing) {
  // The second term is what a needle without area still has along its length.
  return area(shape) / (spacing * spacing) + 8 * shape.size.sum() / spacing;
}

Surface sample(const OuterShape& shape, double spacing) {
  const Vec3& size = shape.size;
  switch (shape.form) {
    case OuterShape::Form::kSphere: return sample_sphere(size.x(), spacing);
    case OuterShape::Form::kCapsule: return sample_capsule(size.x(), size.y(), spacing);
    case OuterShape::Form::kCylinder: return sample_cylinder(size.x(), size.y(), spacing);
    case OuterShape::Form::kBox: return sample_box(size, spacing);
    case OuterShape::Form::kEllipsoid: return sample_ellipsoid(size, spacing);
    case OuterShape::Form::kMesh: return sample_mesh(*shape.hull, spacing);
    case OuterShape::Form::kNone: break;
  }
  return {};
}

// Boxes: a grid on each face, shared along edges and at corners.

Surface sample_box(const Vec3& half, double spacing) {
  if (0.75 * spacing > half.maxCoeff()) return single_point();
  return BoxGrid(half, spacing).surface();
}

// Meshes: points strewn over the triangles, none nearer to another than the others allow (dart throwing), the same in
// every run.

Surface sample_mesh(const Hull& hull, double spacing) {
  const double squares = hull.area() / (spacing * spacing);
  if (squares < 4 * kPi) return single_point();  // a sphere of that area would have one point
  Strewn strewn(kNearest * spacing);
  Darts darts(hull);
  for (double thrown = 0; thrown < kDarts * squares; ++thrown) strewn.offer(darts.next());
  Surface surface{strewn.take(), {}};
  link(surface, kNearest * spacing);
  return surface;
}

// Spheres, capsules, cylinders and ellipsoids: rings of points around the z axis, from the top down.

Surface sample_sphere(double radius, double spacing) {
  if (spacing > radius) return single_point();
  std::vector<Ring> rings;
  const int count = static_cast<int>(std::ceil(kPi * radius / spacing));
  for (int i = 0; i < count; ++i) {
    const double polar = (i + 0.5) * kPi / count;
    const double sine = fixed::sin(polar), cosine = fixed::cos(polar);
    const int around = static_cast<int>(round_even(2 * kPi * radius * sine / spacing));
    rings.push_back({radius * sine, radius * cosine, sine, cosine, around});
  }
  return surface_of(rings);
}

Surface sample_ellipsoid(const Vec3& radii, double spacing) {
  const double largest = radii.maxCoeff();
  Surface surface = sample_sphere(largest, spacing);
  if (surface.single()) return surface;
  for (SurfacePoint& point : surface.points) {
    point.position = point.position.cwiseProduct(radii) / largest;
    point.normal = point.position.cwiseQuotient(radii).cwiseQuotient(radii).normalized();
  }
  return surface;
}

Surface sample_capsule(double radius, double half_length, double spacing) {
  const int around = count_around(radius, spacing);
  if (around < 3) return single_point();
  std::vector<Ring> rings;
  const int steps = static_cast<int>(std::ceil(kPi * radius / (2 * spacing)));
  for (int i = 0; i < steps; ++i) {
    const double polar = i * kPi / (2 * steps);
    const double sine = fixed::sin(polar), cosine = fixed::cos(polar);
    const int count = count_around(radius * sine, spacing);
    if (count < 2) {
      if (i == 0) rings.push_back({0, half_length + radius, 0, 1, 1});
      continue;
    }
    rings.push_back({radius * sine, half_length + radius * cosine, sine, cosine, count});
  }
  const std::size_t cap = rings.size();
  add_side(rings, radius, half_length, spacing, around);
  mirror(rings, cap);
  return surface_of(rings);
}

Surface sample_cylinder(double radius, double half_length, double spacing) {
  const int around = count_around(radius, spacing);
  const int radii = static_cast<int>(round_even(radius / spacing)) + 1;
  if (around < 3 || std::ceil(2 * half_length / spacing) < 2 || radii == 1) return single_point();
  std::vector<Ring> rings;
  for (int i = 0; i + 1 < radii; ++i) {  // the outermost is the rim, part of the side
    const double inner = radius * i / (radii - 1);
    rings.push_back({inner, half_length, 0, 1, i == 0 ? 1 : count_around(inner, spacing)});
  }
  const std::size_t cap = rings.size();
  add_side(rings, radius, half_length, spacing, around);
  const double between = std::sqrt(0.5);  // the rims look between side and cap
  rings[cap].normal_radial = rings.back().normal_radial = between;
  rings[cap].normal_z = between;
  rings.back().normal_z = -between;
  mirror(rings, cap);
  return surface_of(rings);
}

double default_spacing(std::string_view body) {
  for (const Entry& entry : kTable) {
    if (entry.part == without_side(body)) return entry.spacing;
  }
  return 0;
}

}  // namespace mimo::senses::touch
