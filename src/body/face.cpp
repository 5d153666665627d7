#include "body/face.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/fail.h"
#include "base/functions.h"
#include "base/names.h"
#include "base/numbers.h"
#include "base/turns.h"

namespace mimo::body {
namespace {

using Eigen::Isometry3d;
using Eigen::Map;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d vector(const double* v) { return Map<const Vector3d>(v); }

Joint joint_of(const mjModel& model, const Body& body, const std::string& name) {
  const int id = engine::find_or_fail(model, engine::Kind::kJoint, body.prefix + names::kJoint + name);
  return *std::find_if(body.joints.begin(), body.joints.end(), [=](const Joint& joint) { return joint.id == id; });
}

// +1 or -1: which way a joint turns about an axis of its body. Throws where it turns about another one.
double sign_about(const mjModel& model, const Joint& joint, int axis) {
  const double along = model.jnt_axis[3 * joint.id + axis];
  if (std::abs(along) > 0.999) return along > 0 ? 1 : -1;
  fail(Status::kUnsupported,
       "joint \"{}\" does not turn about the {} axis, so the library cannot make it look at points",
       engine::name(model, engine::Kind::kJoint, joint.id), "xyz"[axis]);
}

// Where a body's frame is in its parent's when its joints stand at these angles; joints that are not named stay as in
// `data`.
Isometry3d place(const mjModel& model, const mjData& data, int body, const std::vector<JointAngle>& angles) {
  const double* quat = model.body_quat + 4 * body;
  Quaterniond turn(quat[0], quat[1], quat[2], quat[3]);
  Vector3d position = vector(model.body_pos + 3 * body);
  const int first = model.body_jntadr[body];
  for (int joint = first; joint < first + model.body_jntnum[body]; ++joint) {
    const int address = model.jnt_qposadr[joint];
    double angle = data.qpos[address];
    for (const JointAngle& given : angles) {
      if (given.joint == joint) angle = given.angle;
    }
    const Vector3d at = vector(model.jnt_pos + 3 * joint);
    const Vector3d anchor = position + turn * at;
    turn = turn_after(turn, turn_about<Quaterniond>(vector(model.jnt_axis + 3 * joint), angle - model.qpos0[address]));
    position = anchor - turn * at;
  }
  return Eigen::Translation3d(position) * turn;
}

Isometry3d pose_of(const mjData& data, int body) {
  const double* quat = data.xquat + 4 * body;
  return Eigen::Translation3d(vector(data.xpos + 3 * body)) * Quaterniond(quat[0], quat[1], quat[2], quat[3]);
}

double within(const Joint& joint, double angle) { return std::clamp(angle, joint.low, joint.high); }

double left_of(const Vector3d& v) { return fixed::atan2(v.y(), v.x()); }
double up_of(const Vector3d& v) { return fixed::atan2(v.z(), length_of(v.x(), v.y())); }

Sightline sightline(const mjData& data, int camera) {
  const double* matrix = data.cam_xmat + 9 * camera;
  return {vector(data.cam_xpos + 3 * camera), {-matrix[2], -matrix[5], -matrix[8]}};
}

double angle_between(const Vector3d& a, const Vector3d& b) { return fixed::atan2(a.cross(b).norm(), a.dot(b)); }

// The head of a body that has one whose joints we know.
int head_of(const Body& body) {
  if (!body.infant)
    fail(Status::kUnsupported, "the agent is not an infant, so the library cannot make it look at points");
  return body.head;
}

constexpr std::string_view kPrefix = names::kFace;

std::string_view material_name(const mjModel& model, int material) { return model.names + model.name_matadr[material]; }

bool is_face(const mjModel& model, int material) {
  return material >= 0 && material_name(model, material).substr(0, kPrefix.size()) == kPrefix;
}

}  // namespace

Eyes::Eyes(const mjModel& model, const Body& body)
    : head_(head_of(body)),
      swivel_(joint_of(model, body, "head_swivel")),
      nod_(joint_of(model, body, "head_tilt")),
      left_(eye(model, body, "left", body.eye_left)),
      right_(eye(model, body, "right", body.eye_right)) {
  if (sign_about(model, swivel_, 2) < 0 || sign_about(model, nod_, 1) < 0) {
    fail(Status::kUnsupported,
         "the head's joints turn the other way round, so the library cannot make it look at points");
  }
}

Eyes::Eye Eyes::eye(const mjModel& model, const Body& body, const std::string& side, int camera) const {
  if (camera < 0) fail(Status::kNotFound, "the model has no camera {}eye_{}", body.prefix, side);
  Eye eye{};
  eye.body = model.cam_bodyid[camera];
  eye.camera = camera;
  eye.pan = joint_of(model, body, side + "_eye_horizontal");
  eye.tilt = joint_of(model, body, side + "_eye_vertical");
  eye.torsion = joint_of(model, body, side + "_eye_torsional");
  eye.pan_sign = sign_about(model, eye.pan, 2);
  eye.tilt_sign = -sign_about(model, eye.tilt, 1);
  return eye;
}

Gaze Eyes::gaze(const mjData& data) const {
  Gaze gaze;
  gaze.left = sightline(data, left_.camera);
  gaze.right = sightline(data, right_.camera);
  const Vector3d &a = gaze.left.direction, &b = gaze.right.direction;
  const Vector3d apart = gaze.left.position - gaze.right.position;
  const double angle = angle_between(a, b);
  gaze.vergence = (b - a).dot(apart) >= 0 ? angle : -angle;
  // The shortest segment between the lines ends at left + s a and right + t b.
  const double cosine = a.dot(b);
  const double square = 1 - cosine * cosine;
  if (square < 1e-12) return gaze;
  const double s = (cosine * b.dot(apart) - a.dot(apart)) / square;
  const double t = (b.dot(apart) - cosine * a.dot(apart)) / square;
  if (s <= 0 || t <= 0) return gaze;
  const Vector3d on_left = gaze.left.position + s * a, on_right = gaze.right.position + t * b;
  gaze.meets = true;
  gaze.point = 0.5 * (on_left + on_right);
  gaze.miss = (on_left - on_right).norm();
  return gaze;
}

Look Eyes::look_at(const mjModel& model, const mjData& data, const Vector3d& point, bool turn_head) const {
  Look look;
  const Vector3d from_chest = pose_of(data, model.body_parentid[head_]).inverse() * point;
  if (turn_head) this->turn_head(model, data, from_chest, look.angles);
  const Vector3d from_head = place(model, data, head_, look.angles).inverse() * from_chest;
  look.errors[0] = turn_eye(model, left_, from_head, look.angles);
  look.errors[1] = turn_eye(model, right_, from_head, look.angles);
  return look;
}

// So that the eyes need not turn up or down, and to the sides alike. The point between the eyes moves with the head:
// a few rounds bring it and the angles together.
void Eyes::turn_head(const mjModel& model, const mjData& data, const Vector3d& point, Angles& angles) const {
  constexpr int kRounds = 50;
  const Vector3d between = 0.5 * (vector(model.body_pos + 3 * left_.body) + vector(model.body_pos + 3 * right_.body));
  angles = {{swivel_.id, swivel_.qpos, data.qpos[swivel_.qpos]}, {nod_.id, nod_.qpos, data.qpos[nod_.qpos]}};
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d to = point - place(model, data, head_, angles) * between;
    angles[0].angle = within(swivel_, left_of(to));
    angles[1].angle = within(nod_, -up_of(to));
  }
}

// Appends the eye's angles; gives the angle by which it misses the point, which is in the head's frame.
double Eyes::turn_eye(const mjModel& model, const Eye& eye, const Vector3d& point, Angles& angles) const {
  const Vector3d to = point - vector(model.body_pos + 3 * eye.body);
  const double pan = within(eye.pan, eye.pan_sign * left_of(to));
  const double tilt = within(eye.tilt, eye.tilt_sign * up_of(to));
  angles.push_back({eye.pan.id, eye.pan.qpos, pan});
  angles.push_back({eye.tilt.id, eye.tilt.qpos, tilt});
  angles.push_back({eye.torsion.id, eye.torsion.qpos, within(eye.torsion, 0)});
  const Vector3d forward = turn_about<Quaterniond>(Vector3d(0, 0, 1), eye.pan_sign * pan) *
                           (turn_about<Quaterniond>(Vector3d(0, 1, 0), -eye.tilt_sign * tilt) * Vector3d::UnitX());
  return angle_between(forward, to);
}

const Face& Faces::find(const std::string& name) const {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Face& face) { return face.name == name; });
  if (geom < 0) fail(Status::kNotFound, "face is \"{}\", but this agent has no face", name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Face& face : all) names.push_back(face.name);
  fail(Status::kNotFound, "no face named \"{}\"; {}", name, choice_of(name, std::move(names)));
}

const Face* Faces::shown(const mjModel& model) const {
  if (geom < 0) return nullptr;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Face& face) { return face.material == model.geom_matid[geom]; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<Face> faces_of(const mjModel& model) {
  std::vector<Face> faces;
  for (int material = 0; material < model.nmat; ++material) {
    if (!is_face(model, material)) continue;
    faces.push_back({std::string(material_name(model, material).substr(kPrefix.size())), material});
  }
  return faces;
}

Faces find_faces(const mjModel& model, const Body& body) {
  Faces faces;
  if (body.head < 0) return faces;
  const int first = model.body_geomadr[body.head];
  for (int geom = first; geom < first + model.body_geomnum[body.head] && faces.geom < 0; ++geom) {
    if (is_face(model, model.geom_matid[geom])) faces.geom = geom;
  }
  faces.all = faces_of(model);
  return faces;
}

std::optional<Mouth> find_mouth(const mjModel& model, const Body& body) {
  // Tangents to the side and down.
  constexpr double kSide = 0.185, kDown = 0.575;
  if (body.head < 0) return std::nullopt;
  Mouth mouth{Eigen::Vector3d::Zero(),
              {Eigen::Vector3d(1, kSide, -kDown).normalized(), Eigen::Vector3d(1, -kSide, -kDown).normalized()}};
  double radius = 0;  // of the skull
  const int first = model.body_geomadr[body.head];
  for (int geom = first; geom < first + model.body_geomnum[body.head]; ++geom) {
    if (model.geom_type[geom] != mjGEOM_SPHERE || !(model.geom_size[3 * geom] > radius)) continue;
    radius = model.geom_size[3 * geom];
    mouth.middle = Eigen::Vector3d(model.geom_pos + 3 * geom);
  }
  return mouth;
}

}  // namespace mimo::body
