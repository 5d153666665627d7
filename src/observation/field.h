// A field is one of the arrays that an observation consists of. A field of the skin has receptors.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/pinhole.h"
#include "base/span.h"
#include "mimo/observation.h"

namespace mimo::observation {

// Receptors: the places in a skin on which a field reports.

struct Receptor {
  int body;
  int geom;
  Eigen::Vector3d position;  // body frame, m
  Eigen::Matrix3d frame;     // rows, body frame: outward normal, first tangent, second tangent

  auto normal() const { return frame.row(0).transpose(); }
};

// Of the header.
enum class ReceptorQuantity : mimo_quantity {
  kBody = MIMO_RECEPTOR_BODY,
  kGeom = MIMO_RECEPTOR_GEOM,
  kPosition = MIMO_RECEPTOR_POSITION,
  kFrame = MIMO_RECEPTOR_FRAME,
};

const char* constant(ReceptorQuantity quantity);  // "MIMO_RECEPTOR_POSITION"
// How many numbers one receptor has of it.
std::size_t width(ReceptorQuantity quantity);
// Of all, one after the other.
void read(Span<const Receptor> receptors, ReceptorQuantity quantity, double* values);

// A field: one of the arrays that an observation consists of.

enum class Type : std::int32_t { kU8 = MIMO_U8, kI32 = MIMO_I32, kF32 = MIMO_F32, kF64 = MIMO_F64 };
enum class Time : int { kEnd = 1, kLastStart = 2 };

std::size_t size_of(Type type);

struct Field {
  std::string name;  // path, "proprioception/position"
  Type type = Type::kF32;
  std::vector<std::size_t> shape;  // 1 to 4 entries
  std::string unit;
  std::string frame;
  Time time = Time::kLastStart;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::vector<std::string> labels;  // one per element of the flattened field; empty for pictures
  std::vector<int> bodies;          // one per element: the part of the body that it is about; empty: none
  Span<const Receptor> receptors;   // on which it reports, in the order of its first axis; their skin outlives it, or
  std::shared_ptr<const std::vector<Receptor>> own_receptors;  // they are these
  bool exempt = false;   // from limits of senses: a task of the user's own tells it, or it is on request
  Pinhole pinhole;       // that a picture is taken through; none for all else
  double foveation = 0;  // of a picture in colour: see Foveation; 0: as it was drawn
  // How fast its nerves are: a share of what large fibres conduct at, or a speed of their own in m/s where it is not 0.
  double nerve_share = 1, nerve_speed = 0;
  double sample_rate = 0;  // of sound, samples a second; 0 for all else
  std::size_t offset = 0;  // in the block; set by the layout

  bool is_picture() const { return pinhole.focal_y > 0; }
  std::size_t count() const;
  std::size_t bytes() const { return count() * size_of(type); }
  // What element i of the flattened field is; "" where there are no labels.
  const char* label(std::size_t i) const;
};

}  // namespace mimo::observation
