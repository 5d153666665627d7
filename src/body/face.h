// An infant's face: where its eyes look, how its joints must stand for them to look at a point, and the faces that it
// shows.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "body/body.h"

namespace mimo::body {

// Where an infant's eyes look, and how its joints must stand for them to look at a point.

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

// Its mouth, as the built-in faces have it, seen from the middle of the head; in the head's frame.
struct Mouth {
  Eigen::Vector3d middle;                  // of the head
  std::array<Eigen::Vector3d, 2> corners;  // left and right, of length 1
};

// Nothing without a head. Of bodies with other faces it is as good a guess as any.
std::optional<Mouth> find_mouth(const mjModel& model, const Body& body);

// The faces that an infant can show: materials of which its head has one at a time.

// Those of the built-in bodies: none, and the six basic emotions of Ekman.
inline constexpr std::array<const char*, 7> kFaces = {"neutral", "enjoyment", "sadness", "surprise",
                                                      "disgust", "anger",     "fear"};

struct Face {
  std::string name;
  int material;
};

struct Faces {
  int geom = -1;          // that shows them; -1: this body has no face
  std::vector<Face> all;  // also those that a user's document adds

  // Throws Status::kNotFound with the names that there are.
  const Face& find(const std::string& name) const;
  // The face that a model shows; null where the head has been given some other material.
  const Face* shown(const mjModel& model) const;
};

// The faces that a model has: materials named "mimo_face_<name>".
std::vector<Face> faces_of(const mjModel& model);

// These, and the geom of the head that has one of them.
Faces find_faces(const mjModel& model, const Body& body);

}  // namespace mimo::body
