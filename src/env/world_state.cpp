// What a world's state consists of.
#include "base/bytes.h"
#include "env/world.h"

namespace mimo::env {
namespace {

// Of something that always takes the same number of bytes: they mean the same only where both are equal.
template <typename Saved>
std::uint64_t kind_of(const std::string& what, const Saved& saved) {
  ByteWriter counter;
  saved.save(counter);
  Hash hash;
  hash.add(what);
  hash.add(std::uint64_t{counter.size()});
  return hash.value();
}

template <typename Saved>
Section section_of(std::string name, std::uint64_t kind, Saved& saved) {
  Section section;
  section.name = std::move(name);
  section.kind = kind;
  section.save = [&saved](ByteWriter& to) { saved.save(to); };
  section.load = [&saved](ByteReader& from) { saved.load(from); };
  return section;
}

}  // namespace

void World::add_sections(Agent& agent, std::vector<Section>& sections) {
  const std::string name = agent.name.empty() ? "agent/" : "agent/" + agent.name + "/";
  sections.push_back(section_of(name + "task", kind_of(options_.task, *agent.task), *agent.task));
  actuation::Actuation& actuation = *agent.actuation;
  sections.push_back(section_of(
      name + "actuation",
      kind_of(std::to_string(static_cast<int>(agent.mode)) + " " + std::to_string(actuation.size()), actuation),
      actuation));
  if (agent.path && agent.path->late()) sections.push_back(agent.path->section(name + "motor delay"));
}

// A sense that remembers nothing has no section: a state also fits a world that looks at it with other senses.
std::vector<Section> World::sections() {
  std::vector<Section> sections;
  sections.push_back(episode_.section());
  sections.push_back(section_of("random", 0, random_));
  for (Agent& agent : agents_) add_sections(agent, sections);
  observer_.list(sections);
  limits_.list(sections);
  Section overrides;
  overrides.name = "overrides";
  overrides.save = [this](ByteWriter& to) { physics_.save_overrides(to); };
  overrides.check = [this](ByteReader& from) { physics_.check_overrides(from); };
  overrides.load = [this](ByteReader& from) { physics_.load_overrides(from); };
  sections.push_back(overrides);
  Section physics = section_of("physics", 0, physics_);  // after overrides: poses follow from both
  physics.check = [this](ByteReader& from) { physics_.check(from); };
  sections.push_back(physics);
  return sections;
}

}  // namespace mimo::env
