#include "capi/fields.h"

#include <algorithm>

#include "capi/check.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

using senses::touch::Sensor;

const observation::Field& field_at(const observation::Layout& layout, std::size_t index) {
  require(index < layout.size(), "index is {}, but there are {} fields", index, layout.size());
  return layout[index];
}

void describe(Span<const Sensor> sensors, const SensorArrays& to) {
  using Positions = Eigen::Map<Eigen::Vector3d>;
  using Frames = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (to.bodies != nullptr) to.bodies[i] = sensors[i].body;
    if (to.geoms != nullptr) to.geoms[i] = sensors[i].geom;
    if (to.positions != nullptr) Positions(to.positions + 3 * i) = sensors[i].position;
    if (to.frames != nullptr) Frames(to.frames + MIMO_TOUCH_FRAME_VALUES * i) = sensors[i].frame;
  }
}

}  // namespace

void describe_size(const observation::Layout& layout, std::size_t* bytes, std::size_t* fields) {
  if (bytes != nullptr) *bytes = layout.bytes();
  if (fields != nullptr) *fields = layout.size();
}

void describe_field(const observation::Layout& layout, std::size_t index, mimo_field* field) {
  const observation::Field& inside = field_at(layout, index);
  mimo_field ours{};
  ours.dtype = static_cast<int32_t>(inside.type);
  ours.name = inside.name.c_str();
  ours.unit = inside.unit.c_str();
  ours.frame = inside.frame.c_str();
  ours.offset = inside.offset;
  ours.bytes = inside.bytes();
  std::copy(inside.shape.begin(), inside.shape.end(), std::begin(ours.shape));
  ours.ndim = static_cast<uint32_t>(inside.shape.size());
  ours.time = static_cast<int32_t>(inside.time);
  ours.low = inside.low;
  ours.high = inside.high;
  write_described(field, ours, "field");
}

const char* label_of(const observation::Layout& layout, std::size_t index, std::size_t element) {
  const observation::Field& field = field_at(layout, index);
  require(element < field.count(), "element is {}, but {} has {} elements", element, field.name, field.count());
  return field.label(element);
}

std::uint8_t* block_of(const observation::Layout& layout, void* block, std::size_t bytes) {
  auto* start = static_cast<std::uint8_t*>(block);
  check_buffer(start, bytes, layout.bytes(), "block");
  return start;
}

void describe_skin(const senses::touch::Skin* skin, const SensorArrays& to, std::size_t capacity, std::size_t* count) {
  const Span<const Sensor> sensors = skin == nullptr ? Span<const Sensor>() : Span<const Sensor>(skin->sensors());
  check_length<double[MIMO_TOUCH_FRAME_VALUES]>(capacity, "capacity");
  if (count != nullptr) *count = sensors.size();
  if (to.any() && capacity < sensors.size()) {
    fail(Status::kBufferTooSmall, "capacity is {}, but there are {} sensors", capacity, sensors.size());
  }
  describe(sensors, to);
}

}  // namespace mimo::capi
