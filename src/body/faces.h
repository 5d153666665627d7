// The faces that an infant can show: materials of which its head has one at a time.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "body/body.h"

namespace mimo::body {

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
