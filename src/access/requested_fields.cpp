#include "access/requested_fields.h"

#include <algorithm>

#include "access/body_frame.h"
#include "base/fail.h"

namespace mimo::access {
namespace {

constexpr int kNone = -1;

const char* unit_of(const mjModel& model, const Quantity& what, const std::vector<std::int32_t>& ids) {
  if (what.kind().number != MIMO_JOINT) return what.unit;
  const auto all = [&](int type) {
    return std::all_of(ids.begin(), ids.end(), [&](int id) { return model.jnt_type[id] == type; });
  };
  return all(mjJNT_HINGE) ? what.unit : all(mjJNT_SLIDE) ? what.slide_unit : "";
}

std::string frame_of(const FieldOptions& wanted) {
  if (!wanted.relative_to.empty()) return wanted.relative_to;
  const Quantity& what = *wanted.quantity;
  return *what.frame == '\0' ? what.kind().frame : what.frame;
}

observation::Time time_of(const FieldOptions& wanted) {
  const bool at_end = wanted.now || wanted.quantity->moment == Moment::kAlways;
  return at_end ? observation::Time::kEnd : observation::Time::kLastStart;
}

// Elements x values of each, as far as these are as many.
std::vector<std::size_t> shape_of(const Quantity& what, const std::vector<int>& widths) {
  const auto first = static_cast<std::size_t>(widths[0]);
  if (what.kind().number == MIMO_WORLD) return {first};
  if (std::any_of(widths.begin(), widths.end(), [&](int width) { return width != widths[0]; })) {
    std::size_t sum = 0;
    for (const int width : widths) sum += static_cast<std::size_t>(width);
    return {sum};
  }
  if (first == 1) return {widths.size()};
  return {widths.size(), first};
}

}  // namespace

void check(const FieldOptions& wanted) {
  const Quantity& what = *wanted.quantity;
  require(what.kind().alike(), "quantity is {}, of which worlds have different numbers: it cannot be a field",
          what.constant);
  if (wanted.now) require_known_now(what);
  const bool of_world = what.kind().number == MIMO_WORLD;
  require(of_world == wanted.elements.empty(), "element_count is {}, expected {} of {}", wanted.elements.size(),
          of_world ? "0" : "at least 1", what.constant);
  require(wanted.relative_to.empty() || what.spatial != Spatial::kNone, "relative_to is \"{}\", but {} has no frame",
          wanted.relative_to, what.constant);
}

RequestedFields::RequestedFields(const mjModel& model, const env::World* world, const std::vector<FieldOptions>& wanted)
    : world_(world) {
  std::size_t most = 0;
  for (const FieldOptions& field : wanted) {
    readers_.push_back(reader_of(model, field));
    fields_.push_back(field_of(model, field, readers_.back()));
    most = std::max(most, readers_.back().count);
    if (readers_.back().now) present_.make_room(model);
  }
  values_.resize(most);
}

RequestedFields::Reader RequestedFields::reader_of(const mjModel& model, const FieldOptions& wanted) const {
  const Quantity& what = *wanted.quantity;
  Reader reader{wanted.quantity, wanted.now && what.moment == Moment::kPose, {}, kNone, 0};
  try {
    for (const std::string& element : wanted.elements) {
      reader.ids.push_back(find_or_fail(model, world_, what.kind(), element));
    }
    if (!wanted.relative_to.empty()) {
      reader.relative_to = engine::find_or_fail(model, engine::Kind::kBody, wanted.relative_to);
    }
  } catch (const Error& error) {
    fail(error.status(), "field \"{}\": {}", wanted.name, error.what());
  }
  if (what.kind().number == MIMO_WORLD) reader.ids.push_back(0);
  return reader;
}

observation::Field RequestedFields::field_of(const mjModel& model, const FieldOptions& wanted, Reader& reader) const {
  const Quantity& what = *wanted.quantity;
  observation::Field field;
  std::vector<int> widths;
  for (std::size_t i = 0; i < reader.ids.size(); ++i) {
    widths.push_back(width(what, model, world_, reader.ids[i]));
    const std::string label = what.kind().number == MIMO_WORLD ? "" : wanted.elements[i];
    field.labels.insert(field.labels.end(), static_cast<std::size_t>(widths.back()), label);
  }
  field.name = wanted.name;
  field.shape = shape_of(what, widths);
  reader.count = field.count();
  if (reader.count == 0) {
    fail(Status::kUnsupported, "field \"{}\": {}, but {} has none", wanted.name, words(what.constant),
         wanted.elements[0].empty() ? "the agent" : wanted.elements[0]);
  }
  field.unit = unit_of(model, what, reader.ids);
  field.frame = frame_of(wanted);
  field.time = time_of(wanted);
  field.exempt = true;
  return field;
}

void RequestedFields::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  const mjData* now = nullptr;
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    const Reader& reader = readers_[i];
    if (reader.now && now == nullptr) now = &present_.of(model, data);
    read(model, reader.now ? *now : data, reader);
    float* out = at<float>(block, i);
    for (std::size_t k = 0; k < reader.count; ++k) out[k] = static_cast<float>(values_[k]);
  }
}

void RequestedFields::read(const mjModel& model, const mjData& data, const Reader& reader) {
  access::read({model, data, world_}, *reader.quantity, Ids(Span<const std::int32_t>(reader.ids)),
               Span<double>(values_.data(), reader.count));
  if (reader.relative_to == kNone) return;
  const Quantity& what = *reader.quantity;
  const BodyFrame frame(model, data, reader.relative_to);
  for (std::size_t i = 0; i < reader.ids.size(); ++i) {
    frame.see(what.spatial, place_of(data, what.kind().number, reader.ids[i]),
              values_.data() + i * static_cast<std::size_t>(what.width));
  }
}

}  // namespace mimo::access
