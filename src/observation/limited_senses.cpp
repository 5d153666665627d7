#include "observation/limited_senses.h"

#include <algorithm>
#include <optional>

#include "base/fail.h"
#include "base/format.h"

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
    if (!begins_with(name, prefix)) continue;
    all += (all.empty() ? "" : ", ") + name.substr(prefix.size());
  }
  return all;
}

}  // namespace

void LimitedSenses::add(const std::string& prefix, const std::vector<PathLimits>& paths, const NatureOf& nature_of,
                        const Clock& clock) {
  const Layout& layout = observer_.layout();
  std::vector<std::optional<Limits>> chosen(layout.size());
  for (const PathLimits& entry : paths) {
    const std::string path = prefix + entry.path;
    bool found = false;
    for (std::size_t i = 0; i < layout.size(); ++i) {
      if (!leads_to(path, layout[i].name)) continue;
      require(!layout[i].exempt, "limits: \"{}\" is a field of the task or the scene, to which limits do not apply",
              layout[i].name);
      chosen[i] = meant_for(layout[i], path, entry.limits);
      found = true;
    }
    if (!found && !entry.may_lead_nowhere) {
      fail(Status::kNotFound, "limits: no field \"{}\" and none below; there are: {}", entry.path,
           names(layout, prefix));
    }
  }
  for (std::size_t i = 0; i < layout.size(); ++i) {
    Nature nature = nature_of && !layout[i].exempt ? nature_of(layout[i]) : Nature{};
    if (chosen[i]) nature.delays.clear();
    const Limits limits = chosen[i].value_or(Limits{});
    if (limits.any() || nature.any() || layout[i].foveation > 0) fields_.emplace_back(layout[i], limits, nature, clock);
  }
}

void LimitedSenses::make_room() {
  for (std::size_t i = 0; i < observer_.senses(); ++i) {
    Member member{i};
    const Sense& sense = observer_.sense(i);
    for (LimitedField& field : fields_) {
      if (sense.has(field.field())) member.limited.push_back(&field);
    }
    const auto late = std::count_if(member.limited.begin(), member.limited.end(),
                                    [](const LimitedField* field) { return field->late(); });
    member.now = late < static_cast<std::ptrdiff_t>(sense.fields().size());
    const bool flickers = std::any_of(member.limited.begin(), member.limited.end(),
                                      [](const LimitedField* field) { return field->flickers(); });
    if (late > 0 || flickers) room_.resize(observer_.layout().bytes());
    members_.push_back(std::move(member));
  }
}

const DelayLine* LimitedSenses::delay(const Field& field) const {
  for (const LimitedField& limited : fields_) {
    if (&limited.field() == &field && limited.late()) return &limited.delay();
  }
  return nullptr;
}

bool LimitedSenses::remembers(const LimitedField& field, Moment moment, std::uint64_t tick) {
  if (!field.late()) return moment == Moment::kEnd && field.flickers();
  return field.delay().wants(tick) || (moment == Moment::kEnd && !field.delay().begun());
}

bool LimitedSenses::remembers(const Member& member, Moment moment, std::uint64_t tick) {
  return std::any_of(member.limited.begin(), member.limited.end(),
                     [=](const LimitedField* field) { return remembers(*field, moment, tick); });
}

bool LimitedSenses::wants(std::uint64_t tick) const {
  return !room_.empty() && std::any_of(members_.begin(), members_.end(), [tick](const Member& member) {
    return remembers(member, Moment::kWithin, tick);
  });
}

// Of what was just sensed.
void LimitedSenses::take(const Member& member, std::uint8_t* block, Moment moment, std::uint64_t tick) {
  for (LimitedField* field : member.limited) {
    const bool kept = remembers(*field, moment, tick);
    if (kept || !field->late()) field->weaken(block, tick, LimitedField::Memory::kKeep);
    if (kept && field->late()) field->delay().keep(block, tick);
  }
}

void LimitedSenses::finish(std::uint8_t* block, std::uint64_t episode, std::uint64_t tick) {
  for (LimitedField& field : fields_) {
    if (field.late()) field.delay().recall(block, tick);
    field.disturb(block, episode, tick);
  }
  observer_.layout().clear_gaps(block);
}

void LimitedSenses::begin(const mjModel& model, const mjData& data, std::uint8_t* block, std::uint64_t episode) {
  for (LimitedField& field : fields_) field.forget();
  step(model, data, block, episode, 0, nullptr);
}

void LimitedSenses::pass(const mjModel& model, const mjData& data, std::uint64_t tick, ShareTimes* times) {
  for (const Member& member : members_) {
    if (!remembers(member, Moment::kWithin, tick)) continue;
    observer_.write(member.sense, model, data, room_.data(), times);
    take(member, room_.data(), Moment::kWithin, tick);
  }
}

// What comes late as a whole, and is not remembered as it is now, is not even looked at.
void LimitedSenses::step(const mjModel& model, const mjData& data, std::uint8_t* block, std::uint64_t episode,
                         std::uint64_t tick, ShareTimes* times) {
  std::uint8_t* to = block != nullptr ? block : room_.data();
  for (const Member& member : members_) {
    if (!(block != nullptr && member.now) && !remembers(member, Moment::kEnd, tick)) continue;
    observer_.write(member.sense, model, data, to, times);
    take(member, to, Moment::kEnd, tick);
  }
  if (block != nullptr) finish(block, episode, tick);
}

void LimitedSenses::look(const mjModel& model, const mjData& data, std::uint8_t* block, std::uint64_t episode,
                         std::uint64_t tick) {
  for (const Member& member : members_) {
    const bool fresh = std::any_of(member.limited.begin(), member.limited.end(),
                                   [](const LimitedField* field) { return field->late() && !field->delay().begun(); });
    if (!member.now && !fresh) continue;
    observer_.write(member.sense, model, data, block, nullptr);
    for (LimitedField* field : member.limited) field->weaken(block, tick, LimitedField::Memory::kLeave);
  }
  finish(block, episode, tick);
}

void LimitedSenses::list(std::vector<Section>& sections) {
  for (LimitedField& field : fields_) field.list(sections);
}

}  // namespace mimo::observation
