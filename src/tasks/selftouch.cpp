// Self-touch: the infant is to find out what of its body its hands can touch. Which geoms they have touched in the
// episode is known twice: as the competition BabyBench counts them, and right.
#include <algorithm>
#include <array>

#include "engine/contacts.h"
#include "engine/model.h"
#include "tasks/task.h"

namespace mimo::tasks {
namespace {

constexpr Parameter kParameters[] = {
    {"selftouch/episode_steps", 1000, 0, 1e9, "Steps after which an episode is cut off; 0: never"},
    {"selftouch/touch_reward", 0, -1e9, 1e9,
     "Reward for each geom that a hand, with its fingers, touches for the first time in the episode"},
    {"selftouch/settle_steps", 100, 0, 10000, "Physics steps without control at the start of an episode"},
    {"selftouch/warm_up_steps", 10, 0, 10000, "Physics steps of random actions after that"},
};

constexpr const char* kHands[] = {"right_hand", "left_hand"};
constexpr int kSides = 2;

class Selftouch : public Task {
 public:
  Selftouch(const mjModel& model, const body::Body& body, const Settings& settings);
  void reset(engine::Physics&, Random&) override { std::fill(first_touch_.begin(), first_touch_.end(), 0); }
  Opening opening() const override { return opening_; }
  void evaluate(const engine::Physics& physics) override;
  // For each geom of the body, four times: of the right palm, the left palm, the right hand with its fingers, the left
  // hand with its fingers: 1 if there is something to touch; in which step that was, 0 while it was not.
  int goal_size() const override { return static_cast<int>(first_touch_.size()); }
  void goal(const mjData&, double* out) const override { std::copy(touchable_.begin(), touchable_.end(), out); }
  void achieved(const mjData&, double* out) const override { std::copy(first_touch_.begin(), first_touch_.end(), out); }
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

 private:
  enum Who { kPalm, kHand };  // with its fingers
  // What a geom of the model is: its number among those of the body, and whose palm and hand it belongs to; -1 if none.
  struct Part {
    int number = -1;
    int palm = -1, hand = -1;
  };

  void tell_parts(const mjModel& model, const body::Body& body);
  std::size_t place(Who who, int side, int number) const;
  void credit_palm(int one, int other);
  void credit_hand(int own, int other);
  bool touch(Who who, int side, int geom);

  std::vector<Part> parts_;  // of all geoms of the model
  int count_ = 0;            // of the body
  std::vector<std::uint8_t> touchable_;
  double touch_reward_;
  Opening opening_;
  // State of the episode.
  std::vector<std::uint32_t> first_touch_;  // step, of what place() numbers
  int found_ = 0;                           // in this step
};

Selftouch::Selftouch(const mjModel& model, const body::Body& body, const Settings& settings)
    : Task({{"new_touches", 0}}), parts_(static_cast<std::size_t>(model.ngeom)) {
  tell_parts(model, body);
  touchable_.resize(static_cast<std::size_t>(2 * kSides * count_));
  first_touch_.resize(touchable_.size());
  for (const Part& part : parts_) {
    for (int side = 0; side < kSides && part.number >= 0; ++side) {
      touchable_[place(kPalm, side, part.number)] = part.palm == side ? 0 : 1;
      touchable_[place(kHand, side, part.number)] = part.hand == side ? 0 : 1;
    }
  }
  const auto get = [&](const char* name) { return settings[std::string("selftouch/") + name]; };
  episode_steps_ = static_cast<std::uint64_t>(get("episode_steps"));
  touch_reward_ = get("touch_reward");
  opening_ = {static_cast<int>(get("settle_steps")), static_cast<int>(get("warm_up_steps"))};
}

void Selftouch::tell_parts(const mjModel& model, const body::Body& body) {
  const auto find = [&](const char* name) {
    return engine::find_or_fail(model, engine::Kind::kBody, body.prefix + name);
  };
  const auto each_geom = [&](const std::vector<int>& bodies, auto&& tell) {
    for (int geom = 0; geom < model.ngeom; ++geom) {
      const bool is = std::find(bodies.begin(), bodies.end(), model.geom_bodyid[geom]) != bodies.end();
      if (is) tell(parts_[static_cast<std::size_t>(geom)]);
    }
  };
  each_geom(body::subtree(model, find("hip")), [this](Part& part) { part.number = count_++; });
  for (int side = 0; side < kSides; ++side) {
    const int palm = find(kHands[side]);
    each_geom({palm}, [=](Part& part) { part.palm = side; });
    each_geom(body::subtree(model, palm), [=](Part& part) { part.hand = side; });
  }
}

std::size_t Selftouch::place(Who who, int side, int number) const {
  return static_cast<std::size_t>((who * kSides + side) * count_ + number);
}

// Contacts count whatever their force.
void Selftouch::evaluate(const engine::Physics& physics) {
  found_ = 0;
  for (const engine::Meeting& met : engine::Contacts(physics.model(), physics.data())) {
    if (!met.is_of_geoms()) continue;  // no flex is part of a body
    const auto [first, second] = met.geoms;
    credit_palm(first, second);
    credit_hand(first, second);
    credit_hand(second, first);
  }
  terms_[0].value = touch_reward_ * found_;
}

// As the competition has it: palms alone, and a contact counts once, for the right one first.
void Selftouch::credit_palm(int one, int other) {
  const std::array<int, 2> palms = {parts_[static_cast<std::size_t>(one)].palm,
                                    parts_[static_cast<std::size_t>(other)].palm};
  for (int side = 0; side < kSides; ++side) {
    if (palms[0] == side) return static_cast<void>(touch(kPalm, side, other));
    if (palms[1] == side) return static_cast<void>(touch(kPalm, side, one));
  }
}

// What belongs to the hand itself does not count.
void Selftouch::credit_hand(int own, int other) {
  const int side = parts_[static_cast<std::size_t>(own)].hand;
  if (side < 0 || parts_[static_cast<std::size_t>(other)].hand == side) return;
  if (touch(kHand, side, other)) ++found_;
}

// Whether that is a geom of the body, touched for the first time.
bool Selftouch::touch(Who who, int side, int geom) {
  const int number = parts_[static_cast<std::size_t>(geom)].number;
  if (number < 0) return false;
  std::uint32_t& first = first_touch_[place(who, side, number)];
  if (first != 0) return false;
  first = static_cast<std::uint32_t>(step_.number);
  return true;
}

void Selftouch::save(ByteWriter& to) const {
  Task::save(to);
  to.put(Span<const std::uint32_t>(first_touch_));
}

void Selftouch::load(ByteReader& from) {
  Task::load(from);
  from.take(Span<std::uint32_t>(first_touch_));
}

}  // namespace

const Definition kSelftouch = {
    "selftouch",
    {kParameters, std::size(kParameters)},
    [](const mjModel& model, const body::Body& body, const Settings& settings) -> std::unique_ptr<Task> {
      return std::make_unique<Selftouch>(model, body, settings);
    }};

}  // namespace mimo::tasks
