// Spheres, capsules, cylinders and ellipsoids: rings of points around the z axis, from the top down.
#include <cmath>

#include "base/angle.h"
#include "senses/touch/surface.h"

namespace mimo::senses::touch {
namespace {

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
    const Vec3 radial(std::cos(angle), std::sin(angle), 0);
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

}  // namespace

Surface sample_sphere(double radius, double spacing) {
  if (spacing > radius) return single_point();
  std::vector<Ring> rings;
  const int count = static_cast<int>(std::ceil(kPi * radius / spacing));
  for (int i = 0; i < count; ++i) {
    const double polar = (i + 0.5) * kPi / count;
    const double sine = std::sin(polar), cosine = std::cos(polar);
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
    const double sine = std::sin(polar), cosine = std::cos(polar);
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

}  // namespace mimo::senses::touch
