// The limits of a world's senses: what is done to an observation after it was made. Without any it costs nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "observation/limited_field.h"
#include "observation/observer.h"

namespace mimo::observation {

// Limits of a field, or of all below a path.
struct PathLimits {
  std::string path;  // "touch", "proprioception/velocity"
  Limits limits;
  bool may_lead_nowhere = false;  // limits nothing where no field has that path
};

// An agent's natural limits in a field; empty for fields of other agents.
using NatureOf = std::function<Nature(const Field& field)>;

class LimitedSenses {
 public:
  // What is limited belongs to the observer, which outlives this object.
  explicit LimitedSenses(const Observer& observer) : observer_(observer) {}

  // `prefix` is that of the agent's fields; the observer has all senses by now. Where several limits concern a field,
  // the last one counts, also instead of its delays by nature. Throws Status::kNotFound for a path that leads to no
  // field and has to.
  void add(const std::string& prefix, const std::vector<PathLimits>& paths, const NatureOf& nature, const Clock& clock);
  // After all were added.
  void make_room();

  // Null where a field is not late.
  const DelayLine* delay(const Field& field) const;
  // Whether anything has to be sensed at this tick of an episode, which ends no step.
  bool wants(std::uint64_t tick) const;

  // An episode's first observation. Noise follows from `episode`, the seed of its noise, and the tick. Blocks may be
  // null: what is late is sensed all the same.
  void begin(const mjModel& model, const mjData& data, std::uint8_t* block, std::uint64_t episode);
  // A tick within a step.
  void pass(const mjModel& model, const mjData& data, std::uint64_t tick, ShareTimes* times);
  // The end of a step.
  void step(const mjModel& model, const mjData& data, std::uint8_t* block, std::uint64_t episode, std::uint64_t tick,
            ShareTimes* times);
  // A look in between, which changes nothing here.
  void look(const mjModel& model, const mjData& data, std::uint8_t* block, std::uint64_t episode, std::uint64_t tick);

  // What is late, for a state. This object outlives them, and nothing is added to it any more.
  void list(std::vector<Section>& sections);

 private:
  // One of the observer's senses, and its fields here.
  struct Member {
    std::size_t sense;
    bool now = true;  // some of its fields are not late
    std::vector<LimitedField*> limited{};
  };
  // When fields are looked at. What was never sensed before starts with the end of a step.
  enum class Moment { kWithin, kEnd };
  // Of what comes late or is seen slowly, whether it is remembered as it is at this tick.
  static bool remembers(const LimitedField& field, Moment moment, std::uint64_t tick);
  static bool remembers(const Member& member, Moment moment, std::uint64_t tick);
  static void take(const Member& member, std::uint8_t* block, Moment moment, std::uint64_t tick);
  void finish(std::uint8_t* block, std::uint64_t episode, std::uint64_t tick);

  const Observer& observer_;
  std::vector<LimitedField> fields_;
  std::vector<Member> members_;
  std::vector<std::uint8_t> room_;  // used if the caller gives no block; empty if no field is delayed
};

}  // namespace mimo::observation
