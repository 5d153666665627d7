// Where an infant's eyes look, and how its joints must stand for them to look at a point.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "body/body.h"

namespace mimo::body {

// A line of sight in the world: from a camera along its axis.
struct Sightline {
  Eigen::Vector3d position, direction;
};

struct Gaze {
  Sightline left, right;
  double vergence = 0;                              // angle between the lines, rad; negative where they lead apart
  bool meets = false;                               // whether they come closest to each other before both eyes
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // half-way between them where they do; else zero
  double miss = 0;                                  // how far they pass each other there, m
};

struct JointAngle {
  int joint;
  int qpos;  // address
  double angle;
};

// What looking at a point takes: six joints of the eyes, and before them swivel and tilt of the head where it may turn.
struct Look {
  std::vector<JointAngle> angles;  // within the joints' ranges
  std::array<double, 2> errors{};  // angles by which the left and the right eye miss the point, rad
};

class Eyes {
 public:
  // Throws Status::kNotFound where joints or cameras are missing, kUnsupported where the joints turn about other axes
  // than those of the built-in bodies: swivel and pan about z, tilt about y, torsion about x.
  Eyes(const mjModel& model, const Body& body);

  // As the poses in `data` say.
  Gaze gaze(const mjData& data) const;

  // How many joints looking takes.
  static std::size_t joints(bool turn_head) { return turn_head ? 8 : 6; }
  // At a point of the world, from where the chest is in `data`. The eyes do not roll.
  Look look_at(const mjModel& model, const mjData& data, const Eigen::Vector3d& point, bool turn_head) const;

 private:
  struct Eye {
    int body, camera;
    Joint pan, tilt, torsion;
    double pan_sign, tilt_sign;  // of the joints' axes: +z turns to the left, -y upwards
  };
  using Angles = std::vector<JointAngle>;

  Eye eye(const mjModel& model, const Body& body, const std::string& side, int camera) const;
  void turn_head(const mjModel& model, const mjData& data, const Eigen::Vector3d& point, Angles& angles) const;
  double turn_eye(const mjModel& model, const Eye& eye, const Eigen::Vector3d& point, Angles& angles) const;

  int head_;
  Joint swivel_, nod_;
  Eye left_, right_;
};

}  // namespace mimo::body
