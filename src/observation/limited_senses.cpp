#include "observation/limited_senses.h"

#include <algorithm>

#include "base/fail.h"

namespace mimo::observation {
namespace {

bool leads_to(const std::string& path, const std::string& field) {
  return field == path || field.compare(0, path.size() + 1, path + "/") == 0;
}

// Of depth and segmentation, whose numbers are no brightness, only the delay is meant unless they are named.
Limits meant_for(const Field& field, const std::string& path, const Limits& limits) {
  const bool in_colour = field.type == Type::kU8;
  if (field.frame != "camera" || in_colour || field.name == path) return limits;
  Limits late;
  late.delay = limits.delay;
  return late;
}

std::string names(const Layout& layout, const std::string& prefix) {
  std::string all;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    const std::string& name = layout[i].name;
    if (name.compare(0, prefix.size(), prefix) != 0) continue;
    all += (all.empty() ? "" : ", ") + name.substr(prefix.size());
  }
  return all;
}

}  // namespace

void LimitedSenses::add(const Layout& layout, const std::string& prefix, const std::vector<PathLimits>& paths,
                        double step) {
  std::vector<Limits> chosen(layout.size());
  for (const PathLimits& entry : paths) {
    const std::string path = prefix + entry.path;
    bool found = false;
    for (std::size_t i = 0; i < layout.size(); ++i) {
      if (!leads_to(path, layout[i].name)) continue;
      require(!layout[i].exempt, "limits: \"{}\" is a field of the task or the scene, which limits do not concern",
              layout[i].name);
      chosen[i] = meant_for(layout[i], path, entry.limits);
      found = true;
    }
    if (!found) {
      fail(Status::kNotFound, "limits: no field \"{}\" and none below; there are: {}", entry.path,
           names(layout, prefix));
    }
  }
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (chosen[i].any()) fields_.emplace_back(layout[i], chosen[i], step);
  }
}

void LimitedSenses::make_room(const Layout& layout) {
  if (std::any_of(fields_.begin(), fields_.end(), [](const LimitedField& field) { return field.late(); })) {
    room_.resize(layout.bytes());
  }
}

std::size_t LimitedSenses::delay(const Field& field) const {
  for (const LimitedField& limited : fields_) {
    if (&limited.field() == &field) return limited.delay();
  }
  return 0;
}

void LimitedSenses::weaken(std::uint8_t* block, std::uint64_t episode, std::uint64_t step) {
  for (LimitedField& field : fields_) field.weaken(block, episode, step);
}

void LimitedSenses::begin(std::uint8_t* block, std::uint64_t episode) {
  weaken(block, episode, 0);
  for (LimitedField& field : fields_) field.begin(block);
}

void LimitedSenses::step(std::uint8_t* block, std::uint64_t episode, std::uint64_t step) {
  weaken(block, episode, step);
  for (LimitedField& field : fields_) {
    field.keep(block, step);
    field.recall(block, step);
  }
}

void LimitedSenses::look(std::uint8_t* block, std::uint64_t episode, std::uint64_t step) {
  weaken(block, episode, step);
  for (const LimitedField& field : fields_) field.recall(block, step);
}

void LimitedSenses::list(std::vector<Section>& sections) {
  for (LimitedField& field : fields_) {
    if (field.late()) sections.push_back(field.section());
  }
}

}  // namespace mimo::observation
