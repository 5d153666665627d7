// Quantities that remember: what another quantity was, and how long or how often a condition has held.
#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/names.h"
#include "tasks/behaviour/measures.h"

namespace mimo::tasks {
namespace {

using Words = std::vector<std::string>;

constexpr const char *kSeconds = "s", *kTimes = "times", *kShare = "";

// A condition that did not hold for this long begins anew when it holds again: a hand that slaps a table bounces.
constexpr double kApart = 0.1;  // s

class Condition {
 public:
  Condition(Maker& maker, const std::string& text) : goal_(maker.condition(text)) {}
  bool holds(const Moment& now) const { return goal_.met(goal_.quantity->look(now)); }

 private:
  Goal goal_;
};

// Tells when a condition begins to hold; one that holds when the episode begins does not begin.
class Onset {
 public:
  Onset(Maker& maker, const std::string& text) : condition_(maker, text), last_(maker.keep(1)) {}

  bool look(const Moment& now) const {
    double& last = now.memory[last_];  // when it held last
    if (now.begins()) last = -2 * kApart;
    const bool holds = condition_.holds(now);
    const double paused = now.time - now.seconds - last;  // until the moment before
    const bool begins = holds && !now.begins() && paused > kApart;
    if (holds) last = now.time;
    return begins;
  }

 private:
  Condition condition_;
  std::size_t last_;
};

// How much a quantity differs from what it was when the episode began.
class Change : public Quantity {
 public:
  Change(Maker& maker, QuantityPtr of) : Quantity(of->unit()), of_(std::move(of)), at_(maker.keep(1)) {}
  double look(const Moment& now) const override {
    const double is = of_->look(now);
    if (now.begins()) now.memory[at_] = is;
    return is - now.memory[at_];
  }

 private:
  QuantityPtr of_;
  std::size_t at_;
};

// The highest that a quantity was so far, or with the sign -1 the lowest.
class Extreme : public Quantity {
 public:
  Extreme(Maker& maker, QuantityPtr of, double sign)
      : Quantity(of->unit()), of_(std::move(of)), sign_(sign), at_(maker.keep(1)) {}
  double look(const Moment& now) const override {
    const double is = of_->look(now);
    double& kept = now.memory[at_];
    if (now.begins() || sign_ * is > sign_ * kept) kept = is;
    return kept;
  }

 private:
  QuantityPtr of_;
  double sign_;
  std::size_t at_;
};

// The larger or smaller of two.
class OfTwo : public Quantity {
 public:
  OfTwo(QuantityPtr one, QuantityPtr other, bool larger)
      : Quantity(one->unit()), one_(std::move(one)), other_(std::move(other)), larger_(larger) {
    if (std::string(one_->unit()) != other_->unit()) {
      fail(Status::kModel, "{}: {} and {} cannot be compared", names::kReached, one_->unit(), other_->unit());
    }
  }
  double look(const Moment& now) const override {
    const double one = one_->look(now), other = other_->look(now);
    return larger_ ? std::max(one, other) : std::min(one, other);
  }

 private:
  QuantityPtr one_, other_;
  bool larger_;
};

// How long a condition has held: in all, without a break, or as a share of the episode so far.
class Held : public Quantity {
 public:
  enum How { kInAll, kLongest, kShareOfTime };

  Held(Maker& maker, const std::string& condition, How how)
      : Quantity(how == kShareOfTime ? kShare : kSeconds),
        condition_(maker, condition),
        how_(how),
        at_(maker.keep(2)) {}

  double look(const Moment& now) const override {
    double &held = now.memory[at_], &longest = now.memory[at_ + 1];
    const bool holds = condition_.holds(now);
    if (holds) held += now.seconds;
    if (how_ == kInAll) return held;
    if (how_ == kShareOfTime) return now.time > 0 ? held / now.time : 0;
    if (!holds) held = 0;
    longest = std::max(longest, held);
    return longest;
  }

 private:
  Condition condition_;
  How how_;
  std::size_t at_;
};

class Times : public Quantity {
 public:
  Times(Maker& maker, const std::string& condition) : Quantity(kTimes), onset_(maker, condition), at_(maker.keep(1)) {}
  double look(const Moment& now) const override {
    if (onset_.look(now)) ++now.memory[at_];
    return now.memory[at_];
  }

 private:
  Onset onset_;
  std::size_t at_;
};

// How often two conditions began in turns: steps, where each is a foot that touches the ground.
class Alternations : public Quantity {
 public:
  Alternations(Maker& maker, const Words& conditions)
      : Quantity(kTimes), one_(maker, conditions[0]), other_(maker, conditions[1]), at_(maker.keep(2)) {}

  double look(const Moment& now) const override {
    double &count = now.memory[at_], &latest = now.memory[at_ + 1];  // latest: 0 none, 1 the one, 2 the other
    const bool one = one_.look(now), other = other_.look(now);
    for (const auto& [begins, side] : {std::pair(one, 1.0), std::pair(other, 2.0)}) {
      if (!begins || latest == side) continue;
      latest = side;
      ++count;
    }
    return count;
  }

 private:
  Onset one_, other_;
  std::size_t at_;
};

// Of the time in which either of two conditions held, the share of the first; a half before.
class Preference : public Quantity {
 public:
  Preference(Maker& maker, const Words& conditions)
      : Quantity(kShare), one_(maker, conditions[0]), other_(maker, conditions[1]), at_(maker.keep(2)) {}

  double look(const Moment& now) const override {
    double &first = now.memory[at_], &second = now.memory[at_ + 1];
    if (one_.holds(now)) first += now.seconds;
    if (other_.holds(now)) second += now.seconds;
    return first + second > 0 ? first / (first + second) : 0.5;
  }

 private:
  Condition one_, other_;
  std::size_t at_;
};

// A phase of the episode: when it begins, and how long it lasts.
struct Phase {
  double begin, seconds;
};

Phase phase_of(const Maker& maker, const std::string& word) {
  const double number = number_of(word, word);
  const Span<const double> phases = maker.phases();
  if (number != std::floor(number) || number < 1 || number > static_cast<double>(phases.size())) {
    fail(Status::kModel, "{}: phase {} is wanted, and {} has {} phases", names::kReached, word, names::kPhases,
         phases.size());
  }
  Phase phase{0, 0};
  for (std::size_t i = 0; i < static_cast<std::size_t>(number); ++i) {
    phase.begin += phase.seconds;
    phase.seconds = phases[i];
  }
  return phase;
}

// How much more often than in an earlier phase a condition begins in a later one: the ratio of their rates, each over
// its whole phase, so that a first kick is no success. A condition that never began in the earlier one counts as having
// begun once there.
class Gain : public Quantity {
 public:
  Gain(Maker& maker, const Words& words)
      : Quantity(kShare),
        onset_(maker, words[0]),
        later_(phase_of(maker, words[1])),
        earlier_(phase_of(maker, words[2])),
        at_(maker.keep(2)) {}

  double look(const Moment& now) const override {
    double &later = now.memory[at_], &earlier = now.memory[at_ + 1];
    const bool begins = onset_.look(now);
    if (begins && is_in(later_, now.time)) ++later;
    if (begins && is_in(earlier_, now.time)) ++earlier;
    return later / later_.seconds / (std::max(earlier, 1.0) / earlier_.seconds);
  }

 private:
  static bool is_in(const Phase& phase, double time) {
    return time > phase.begin && time <= phase.begin + phase.seconds;
  }

  Onset onset_;
  Phase later_, earlier_;
  std::size_t at_;
};

template <typename Made, typename... Arguments>
QuantityPtr make_memory(Arguments&&... arguments) {
  return std::make_unique<const Made>(std::forward<Arguments>(arguments)...);
}

// One after the other, as arguments of one call would not be: states have their numbers in this order.
QuantityPtr of_two(Maker& maker, const Words& words, bool larger) {
  QuantityPtr one = maker.quantity(words[0]);
  QuantityPtr other = maker.quantity(words[1]);
  return make_memory<OfTwo>(std::move(one), std::move(other), larger);
}

constexpr Kind kMemories[] = {
    {"change", "(QUANTITY)", [](Maker& m, const Words& w) { return make_memory<Change>(m, m.quantity(w[0])); }},
    {"highest", "(QUANTITY)", [](Maker& m, const Words& w) { return make_memory<Extreme>(m, m.quantity(w[0]), 1); }},
    {"lowest", "(QUANTITY)", [](Maker& m, const Words& w) { return make_memory<Extreme>(m, m.quantity(w[0]), -1); }},
    {"larger", "(QUANTITY) (QUANTITY)", [](Maker& m, const Words& w) { return of_two(m, w, true); }},
    {"smaller", "(QUANTITY) (QUANTITY)", [](Maker& m, const Words& w) { return of_two(m, w, false); }},
    {"time", "(CONDITION)", [](Maker& m, const Words& w) { return make_memory<Held>(m, w[0], Held::kInAll); }},
    {"longest", "(CONDITION)", [](Maker& m, const Words& w) { return make_memory<Held>(m, w[0], Held::kLongest); }},
    {"share", "(CONDITION)", [](Maker& m, const Words& w) { return make_memory<Held>(m, w[0], Held::kShareOfTime); }},
    {"times", "(CONDITION)", [](Maker& m, const Words& w) { return make_memory<Times>(m, w[0]); }},
    {"alternations", "(CONDITION) (CONDITION)",
     [](Maker& m, const Words& w) { return make_memory<Alternations>(m, w); }},
    {"preference", "(CONDITION) (CONDITION)", [](Maker& m, const Words& w) { return make_memory<Preference>(m, w); }},
    {"gain", "(CONDITION) PHASE PHASE", [](Maker& m, const Words& w) { return make_memory<Gain>(m, w); }},
};

}  // namespace

Span<const Kind> remembered_kinds() { return {kMemories, std::size(kMemories)}; }

}  // namespace mimo::tasks
