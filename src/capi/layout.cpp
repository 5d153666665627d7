// What observations, actions and rewards consist of.
#include "base/fail.h"
#include "capi/access_arguments.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "observation/foveation.h"

namespace mimo::capi {

OwnLayout own_layout(const env::LiveDescription& description) {
  return OwnLayout(wrap<mimo_layout>(std::make_unique<LayoutObject>(LayoutObject{description})));
}

void RetireLayout::operator()(mimo_layout* layout) const noexcept {
  await_nobody(layout);
  dispose(layout);
}

namespace {

env::LiveDescription::Reading description_of(const mimo_layout* layout) { return open(layout).description.read(); }

const observation::Field& field_at(const env::Description& description, std::size_t index, const char* argument) {
  const auto& fields = description.fields;
  require(index < fields.size(), "{} is {}, but there are {} fields", argument, index, fields.size());
  return fields[index];
}

template <typename T>
const T& part_at(const std::vector<T>& parts, std::size_t index, const char* what) {
  require(index < parts.size(), "index is {}, but there are {} {}", index, parts.size(), what);
  return parts[index];
}

mimo_field described(const observation::Field& inside, const env::Interval& time, double period) {
  mimo_field ours{};
  ours.dtype = static_cast<int32_t>(inside.type);
  ours.name = inside.name.c_str();
  ours.unit = inside.unit.c_str();
  ours.frame = inside.frame.c_str();
  ours.offset = inside.offset;
  ours.bytes = inside.bytes();
  ours.shape = inside.shape.data();
  ours.ndim = inside.shape.size();
  ours.low = inside.low;
  ours.high = inside.high;
  ours.start = time.start;
  ours.end = time.end;
  ours.period = period;
  ours.receptors = inside.receptors.size();
  ours.sample_rate = inside.sample_rate;
  return ours;
}

std::size_t find_field(const std::vector<observation::Field>& fields, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].name == name) return i;
    names.push_back(fields[i].name);
  }
  fail(Status::kNotFound, "no field named \"{}\"; {}", name, choice_of(name, std::move(names)));
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_layout_describe(const mimo_layout* layout, mimo_layout_info* info) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    mimo_layout_info ours{};
    ours.block_bytes = description->block_bytes;
    ours.fields = description->fields.size();
    ours.actions = description->actions.size();
    ours.agents = description->agents;
    ours.terms = description->terms.size();
    ours.step_seconds = description->period;
    write_described(info, ours, "info");
  });
}

mimo_status mimo_layout_field(const mimo_layout* layout, size_t index, mimo_field* field) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const observation::Field& inside = field_at(*description, index, "index");
    write_described(field, described(inside, description->times[index], description->period), "field");
  });
}

mimo_status mimo_layout_find(const mimo_layout* layout, const char* name, size_t* index) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    require(name != nullptr, "name is NULL");
    out(index, "index") = find_field(description->fields, name);
  });
}

mimo_status mimo_layout_label(const mimo_layout* layout, size_t field, size_t element, const char** label) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const observation::Field& inside = field_at(*description, field, "field");
    require(element < inside.count(), "element is {}, but {} has {} elements", element, inside.name, inside.count());
    out(label, "label") = inside.label(element);
  });
}

mimo_status mimo_layout_delays(const mimo_layout* layout, size_t field, double* seconds, size_t count) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const observation::Field& inside = field_at(*description, field, "field");
    const Span<double> to = array(seconds, count, "seconds");
    check_exact(count, inside.count(), "count", ", the elements of " + inside.name);
    description->delays[field].tell(to);
  });
}

mimo_status mimo_layout_directions(const mimo_layout* layout, size_t field, float* directions, size_t count) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const observation::Field& picture = field_at(*description, field, "field");
    require(picture.is_picture(), "field {} is {}, expected a picture", field, picture.name);
    const Span<float> to = array(directions, count, "directions");
    const std::size_t width = picture.shape[1], expected = picture.shape[0] * width * 3;
    check_exact(count, expected, "count", ", the numbers of directions of " + picture.name);
    const observation::FovealMap map = observation::map_of(picture);
    for (std::size_t i = 0; i < count; i += 3) {
      const std::size_t x = i / 3 % width, y = i / 3 / width;
      const auto towards = map.direction({static_cast<double>(x), static_cast<double>(y)});
      std::copy(towards.begin(), towards.end(), to.data() + i);
    }
  });
}

mimo_status mimo_layout_receptor_width(const mimo_layout* layout, size_t field, int32_t quantity,
                                       size_t* value_count) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const observation::Field& inside = field_at(*description, field, "field");
    const std::size_t width = observation::width(receptor_quantity_from(quantity));
    out(value_count, "value_count") = inside.receptors.size() * width;
  });
}

mimo_status mimo_layout_receptors(const mimo_layout* layout, size_t field, int32_t quantity, double* values,
                                  size_t value_count) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const observation::Field& inside = field_at(*description, field, "field");
    const observation::ReceptorQuantity what = receptor_quantity_from(quantity);
    const Span<double> to = array(values, value_count, "values");
    check_exact(value_count, inside.receptors.size() * observation::width(what), "value_count");
    observation::read(inside.receptors, what, to.data());
  });
}

mimo_status mimo_layout_action(const mimo_layout* layout, size_t index, mimo_action* action) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const env::Action& inside = part_at(description->actions, index, "actions");
    mimo_action ours{};
    ours.name = inside.name.c_str();
    ours.unit = inside.unit;
    ours.agent = inside.agent;
    ours.low = inside.low;
    ours.high = inside.high;
    write_described(action, ours, "action");
  });
}

mimo_status mimo_layout_term(const mimo_layout* layout, size_t index, mimo_term* term) noexcept {
  return guard(layout, [&] {
    const auto description = description_of(layout);
    const env::RewardTerm& inside = part_at(description->terms, index, "terms");
    mimo_term ours{};
    ours.name = inside.name.c_str();
    ours.agent = inside.agent;
    write_described(term, ours, "term");
  });
}

}  // extern "C"
