#include "rays/camera.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "render/renderer.h"
#include "render/stage.h"

namespace mimo::rays {
namespace {

// Bounds of what an eye sees, gathered from points with a spread: ellipsoids (also flat ones) and corners.
class Bounds {
 public:
  Bounds(bool parallel, double near_depth) : parallel_(parallel), near_(near_depth) {}

  // An ellipsoid around c in the eye's frame whose extent in direction n is sqrt(n' M n).
  void add(const Vec& c, double xx, double yy, double zz, double xz, double yz) {
    const double depth = std::sqrt(std::max(zz, 0.0));
    nearest_ = std::min(nearest_, c[2] - depth);
    farthest_ = std::max(farthest_, c[2] + depth);
    box_[0].extend(c[0], std::sqrt(std::max(xx, 0.0)));
    box_[1].extend(c[1], std::sqrt(std::max(yy, 0.0)));
    if (parallel_ || nearest_ <= near_) return;
    tangents(slope_[0], c[0], c[2], xx, zz, xz);
    tangents(slope_[1], c[1], c[2], yy, zz, yz);
  }

  // An unlimited plane.
  void add_everything() {
    nearest_ = -kEverywhere;
    farthest_ = kEverywhere;
    box_[0].extend(0, kEverywhere);
    box_[1].extend(0, kEverywhere);
  }

  bool cut() const { return nearest_ <= near_; }  // some of it is too near
  double low(int k) const {
    if (parallel_) return box_[k].low;
    if (!cut()) return slope_[k].low;
    // What is left of a box when it is cut off at the near plane.
    return box_[k].low / (box_[k].low < 0 ? near_ : farthest_);
  }
  double high(int k) const {
    if (parallel_) return box_[k].high;
    if (!cut()) return slope_[k].high;
    return box_[k].high / (box_[k].high > 0 ? near_ : farthest_);
  }
  double nearest() const { return nearest_; }
  double farthest() const { return farthest_; }

 private:
  struct Range {
    double low = kEverywhere;
    double high = -kEverywhere;

    void extend(double middle, double half) {
      low = std::min(low, middle - half);
      high = std::max(high, middle + half);
    }
  };

  // Slopes s = x / z of the lines through the eye that touch the ellipse: (x - s z)^2 = xx - 2 s xz + s^2 zz.
  static void tangents(Range& range, double x, double z, double xx, double zz, double xz) {
    const double a = z * z - zz;
    const double b = x * z - xz;
    const double c = x * x - xx;
    range.extend(b / a, std::sqrt(std::max(b * b - a * c, 0.0)) / a);
  }

  bool parallel_;
  double near_;
  Range box_[2];
  Range slope_[2];
  double nearest_ = kEverywhere;
  double farthest_ = -kEverywhere;
};

// The direction from a point of a solid's surface to `eye`, such that the solid lies behind the plane through that
// point across it; zero if the eye is inside. All in the solid's frame. (For a plane, which has no inside, and a mesh,
// which need not be convex: zero.)
Vec away_from(const Solid& solid, const Vec& eye) {
  const double s0 = solid.size[0];
  const double s1 = solid.size[1];
  const double s2 = solid.size[2];
  const Vec none = Vec::Zero();
  switch (solid.kind) {
    case Form::kPlane: return none;
    case Form::kSphere: return dot(eye, eye) > s0 * s0 ? eye : none;
    case Form::kEllipsoid: {
      const Vec n = {eye[0] / (s0 * s0), eye[1] / (s1 * s1), eye[2] / (s2 * s2)};
      return dot(eye, n) > 1 ? n : none;
    }
    case Form::kCapsule: {
      const Vec n = {eye[0], eye[1], eye[2] - std::clamp(eye[2], -s1, s1)};
      return dot(n, n) > s0 * s0 ? n : none;
    }
    case Form::kCylinder: {
      const double r = length_of(eye[0], eye[1]);
      const double aside = r > s0 ? 1 - s0 / r : 0;
      return {eye[0] * aside, eye[1] * aside, eye[2] - std::clamp(eye[2], -s1, s1)};
    }
    case Form::kBox:
      return {eye[0] - std::clamp(eye[0], -s0, s0), eye[1] - std::clamp(eye[1], -s1, s1),
              eye[2] - std::clamp(eye[2], -s2, s2)};
    case Form::kMesh: return none;
  }
  return none;
}

// Bounds of a solid around c, whose axes these are, in the eye's frame.
void add_bounds(const Solid& solid, const Vec& c, const Eigen::Matrix3d& axis, Bounds& bounds) {
  const double s0 = solid.size[0];
  const double s1 = solid.size[1];
  const double s2 = solid.size[2];
  const auto ball = [&](const Vec& at, double r) { bounds.add(at, r * r, r * r, r * r, 0, 0); };
  switch (solid.kind) {
    case Form::kPlane:
      if (s0 > 0 && s1 > 0) {
        for (int k = 0; k < 4; ++k) {
          bounds.add(c + (k & 1 ? s0 : -s0) * axis.col(0) + (k & 2 ? s1 : -s1) * axis.col(1), 0, 0, 0, 0, 0);
        }
      } else {
        bounds.add_everything();
      }
      break;
    case Form::kSphere: ball(c, s0); break;
    case Form::kCapsule:
      ball(c + s1 * axis.col(2), s0);
      ball(c + -s1 * axis.col(2), s0);
      break;
    case Form::kEllipsoid: {
      double m[5] = {0, 0, 0, 0, 0};
      for (int k = 0; k < 3; ++k) {
        const double square = solid.size[k] * static_cast<double>(solid.size[k]);
        m[0] += square * axis(0, k) * axis(0, k);
        m[1] += square * axis(1, k) * axis(1, k);
        m[2] += square * axis(2, k) * axis(2, k);
        m[3] += square * axis(0, k) * axis(2, k);
        m[4] += square * axis(1, k) * axis(2, k);
      }
      bounds.add(c, m[0], m[1], m[2], m[3], m[4]);
      break;
    }
    case Form::kCylinder: {
      const Vec z = axis.col(2);
      const double r = s0 * s0;
      for (int side = -1; side <= 1; side += 2) {
        bounds.add(c + side * s1 * z, r * (1 - z[0] * z[0]), r * (1 - z[1] * z[1]), r * (1 - z[2] * z[2]),
                   -r * z[0] * z[2], -r * z[1] * z[2]);
      }
      break;
    }
    case Form::kBox:
    case Form::kMesh:
      for (int k = 0; k < 8; ++k) {
        const Vec corner =
            c + (k & 1 ? s0 : -s0) * axis.col(0) + (k & 2 ? s1 : -s1) * axis.col(1) + (k & 4 ? s2 : -s2) * axis.col(2);
        bounds.add(corner, 0, 0, 0, 0, 0);
      }
      break;
  }
}

// Most solids are wholly outside of what a camera shows: their bounding spheres tell, at a tenth of the cost of bounds.
bool misses(const Eye& eye, const Vec& center, double radius, double near_depth) {
  if (eye.rays != Rays::kPerspective || radius == 0) return false;
  const double r = radius * (1 + 1e-4);
  if (center[2] + r < near_depth || center[2] - r > eye.reach) return true;
  const auto beyond = [&](double aside, double slope) {
    const double distance = std::abs(aside) - slope * center[2];  // times the root below
    return distance > 0 && distance * distance > r * r * (1 + slope * slope);
  };
  return beyond(center[0], eye.wide) || beyond(center[1], eye.high);
}

}  // namespace

void Eye::look_at(const Solid& solid, int index, double near_depth) {
  const Vec c = seen_from(axes, solid.position - position);
  if (misses(*this, c, solid.radius, near_depth)) return;
  Eigen::Matrix3d axis;  // of the solid in the eye's frame
  for (int k = 0; k < 3; ++k) axis.col(k) = seen_from(axes, solid.rotation.col(k));
  Aspect aspect;
  aspect.solid = index;
  Bounds bounds(rays == Rays::kParallel, near_depth);
  add_bounds(solid, c, axis, bounds);
  const bool directed = rays != Rays::kAround;
  if (directed && (bounds.farthest() < near_depth || bounds.nearest() > reach)) return;
  // A hair of slack for what is rounded below.
  const auto slack = [](double v) { return 1e-5 * (1 + std::abs(v)); };
  aspect.left = static_cast<float>(bounds.low(0) - slack(bounds.low(0)));
  aspect.right = static_cast<float>(bounds.high(0) + slack(bounds.high(0)));
  aspect.bottom = static_cast<float>(bounds.low(1) - slack(bounds.low(1)));
  aspect.top = static_cast<float>(bounds.high(1) + slack(bounds.high(1)));
  aspect.nearest = static_cast<float>(std::max(bounds.nearest() - slack(bounds.nearest()), -kEverywhere));
  aspect.center = narrow(c);
  aspect.radius = static_cast<float>(solid.kind == Form::kPlane ? kEverywhere : solid.radius);

  if (directed && (aspect.left > wide || aspect.right < -wide || aspect.bottom > high || aspect.top < -high)) {
    return;
  }

  const Vec from_solid = to_local(solid, position - solid.position);
  const Vec right = to_local(solid, axes.col(0));
  const Vec up = to_local(solid, axes.col(1));
  const Vec ahead = to_local(solid, axes.col(2));
  if (rays == Rays::kPerspective && bounds.cut() && solid.kind != Form::kPlane && solid.kind != Form::kMesh) {
    const Vec away = away_from(solid, from_solid);
    if (dot(away, away) == 0) return;  // seen from inside: not at all
    const double middle = dot(away, ahead);
    const double x = dot(away, right);
    const double y = dot(away, up);
    if (middle - std::abs(x) * wide - std::abs(y) * high >= 0) return;
    aspect.facing = narrow({middle, x, y});
  }
  if (rays == Rays::kPerspective && solid.kind == Form::kPlane) {
    const double side = from_solid[2] < 0 ? -1 : 1;
    aspect.facing = narrow({side * ahead[2], side * right[2], side * up[2]});
  }
  aspect.bx = narrow(right);
  aspect.by = narrow(up);
  const std::array<float, 3> forward = narrow(ahead);
  if (rays == Rays::kParallel) {
    aspect.a = narrow(from_solid);
    aspect.o = forward;
  } else {
    aspect.o = narrow(from_solid);
    aspect.a = forward;
  }

  // Nearest first, and of two in one place the later one, which shows: few solids, mostly in order already.
  int place = count++;
  while (place > 0 && aspects[place - 1].nearest >= aspect.nearest) {
    aspects[place] = aspects[place - 1];
    --place;
  }
  aspects[place] = aspect;
}

Camera::Camera(std::size_t most) : seen(most), transparent(most) { aspects.resize(most); }

void Camera::place(const render::Air& air, const render::View& view, double aspect_ratio) {
  near_plane = static_cast<float>(air.near_plane);
  far_plane = static_cast<float>(air.far_plane);
  position = view.position;
  axes = view.rotation;
  axes.col(2) = -axes.col(2);
  reach = far_plane;
  rays = view.parallel ? Rays::kParallel : Rays::kPerspective;
  if (view.edges.given()) {
    high = std::max(std::abs(view.edges.bottom), std::abs(view.edges.top));
    wide = std::max(std::abs(view.edges.left), std::abs(view.edges.right));
    return;
  }
  high = view.half_height();
  wide = high * aspect_ratio;
}

void Camera::look_around(const Solids& solids) {
  count = 0;
  transparent_count = 0;
  for (int i = 0; i < solids.count(); ++i) look_at(solids[i], i, near_plane);
  std::fill(seen.begin(), seen.end(), -2);
  for (int i = 0; i < count; ++i) {
    seen[aspects[i].solid] = i;
    if (solids[aspects[i].solid].transparent) transparent[transparent_count++] = i;
  }
  std::sort(transparent.begin(), transparent.begin() + transparent_count, [&](int a, int b) {
    const int i = aspects[a].solid;
    const int j = aspects[b].solid;
    return solids[i].order != solids[j].order ? solids[i].order < solids[j].order : i < j;
  });
}

Mirror::Mirror(std::size_t most) { eye.aspects.resize(most); }

void Mirror::hold(const Solids& solids, const Camera& camera, bool reflections) {
  eye.count = 0;
  solid = -1;
  if (solids.mirror() < 0 || !reflections) return;
  const Solid& glass = solids[solids.mirror()];
  const Vec normal = glass.rotation.col(2);
  Vec point = glass.position;
  if (glass.kind == Form::kBox) point += static_cast<double>(glass.size[2]) * normal;
  const double height = dot(camera.position - point, normal);
  if (height < 0) return;
  solid = solids.mirror();
  reflectance = glass.material.reflectance;
  eye.position = camera.position + -2 * height * normal;
  for (int k = 0; k < 3; ++k) eye.axes.col(k) = camera.axes.col(k) + -2 * dot(camera.axes.col(k), normal) * normal;
  eye.rays = camera.rays;
  eye.reach = camera.reach;
  eye.wide = camera.wide;
  eye.high = camera.high;
  for (int i = 0; i < solids.count(); ++i) {
    // Only what rises above the mirror shows in it.
    const Solid& other = solids[i];
    if (i == solid) continue;
    if (other.kind != Form::kPlane && dot(other.position - point, normal) < -other.radius) continue;
    eye.look_at(other, i, camera.near_plane);
  }
}

}  // namespace mimo::rays
