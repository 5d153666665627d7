#include "engine/custom.h"

#include <mujoco/mujoco.h>

namespace mimo::engine {
namespace {

std::vector<std::string> names_of(const mjModel& model, mjtObj type, int count) {
  std::vector<std::string> names;
  for (int id = 0; id < count; ++id) {
    const char* name = mj_id2name(&model, type, id);
    names.emplace_back(name == nullptr ? "" : name);
  }
  return names;
}

}  // namespace

std::string custom_text(const mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_TEXT, name.c_str());
  return id < 0 ? "" : model.text_data + model.text_adr[id];
}

std::vector<std::string> custom_number_names(const mjModel& model) {
  return names_of(model, mjOBJ_NUMERIC, static_cast<int>(model.nnumeric));
}

std::vector<std::string> custom_tuple_names(const mjModel& model) {
  return names_of(model, mjOBJ_TUPLE, static_cast<int>(model.ntuple));
}

Span<const double> custom_numbers(const mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_NUMERIC, name.c_str());
  if (id < 0) return {};
  return {model.numeric_data + model.numeric_adr[id], static_cast<std::size_t>(model.numeric_size[id])};
}

std::vector<TupleEntry> custom_tuple(const mjModel& model, const std::string& name, Kind kind) {
  const int id = mj_name2id(&model, mjOBJ_TUPLE, name.c_str());
  std::vector<TupleEntry> entries;
  for (int i = 0; id >= 0 && i < model.tuple_size[id]; ++i) {
    const int at = model.tuple_adr[id] + i;
    if (model.tuple_objtype[at] == object_type(kind))
      entries.push_back({model.tuple_objid[at], model.tuple_objprm[at]});
  }
  return entries;
}

}  // namespace mimo::engine
