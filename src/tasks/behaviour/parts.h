// What words of a behaviour name: parts of the infant, things around it, points on them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "body/body.h"
#include "tasks/infant.h"

namespace mimo::tasks {

// One part or thing: a hand has its fingers and a foot its toes, a thing all that hangs on it, any other part of the
// infant nothing but itself.
struct Part {
  std::vector<int> bodies;   // by whose contacts it touches
  std::vector<int> origins;  // whose middle is its place
};

// A point that moves with a body.
struct Point {
  std::vector<int> origins;                          // their middle
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // from there, in the frame of the first; of one body only

  Eigen::Vector3d in(const mjData& data) const;
};

class Parts {
 public:
  Parts(const mjModel& model, const body::Body& body) : model_(model), body_(body) {}

  // "right_hand", "hands", "body-feet", "hands,knees", "ground", "outside": see docs/guide/behaviours.md. Throws
  // Status::kModel for a word that names nothing here.
  std::vector<Part> parts(const std::string& words) const;
  // "right_fingers", "mouth", or a thing.
  Point point(const std::string& word) const;
  // Of a part with a frame of its own.
  int frame(const std::string& word) const;

  const mjModel& model() const { return model_; }
  const body::Body& body() const { return body_; }

 private:
  int find(const std::string& name) const;  // -1 for no body
  std::vector<Part> one(const std::string& word) const;
  Part part(const std::string& name) const;
  Point mouth() const;

  const mjModel& model_;
  const body::Body& body_;
};

}  // namespace mimo::tasks
