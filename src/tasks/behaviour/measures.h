// What a behaviour can measure: quantities of an infant in its world, made of the words that name them.
//
// A quantity looks at each moment of an episode once, in order, and remembers what it needs in the episode's memory.
// docs/guide/behaviours.md lists the words. Another one is a class and a row in the table of measures.cpp (what is
// there now) or memories.cpp (what was so far).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/span.h"
#include "engine/physics.h"
#include "tasks/behaviour/clauses.h"
#include "tasks/behaviour/parts.h"

namespace mimo::tasks {

struct Moment {
  const mjModel& model;
  const mjData& data;
  double seconds;  // since the moment before; 0: the episode begins
  double time;     // since it began, s
  Span<double> memory;

  bool begins() const { return seconds == 0; }
};

class Quantity {
 public:
  explicit Quantity(const char* unit) : unit_(unit) {}
  virtual ~Quantity() = default;
  virtual double look(const Moment& now) const = 0;
  const char* unit() const { return unit_; }

 private:
  const char* unit_;
};

using QuantityPtr = std::unique_ptr<const Quantity>;

// A quantity, and what it has to reach in this infant's size: lengths of documents are those of the body of 18 months.
struct Goal {
  QuantityPtr quantity;
  bool at_least;
  double threshold;
  std::optional<double> from;

  bool met(double value) const { return at_least ? value >= threshold : value <= threshold; }
  // From 0 to 1, met.
  double progress(double value) const;
};

// Makes the quantities of one behaviour.
class Maker {
 public:
  Maker(const mjModel& model, const body::Body& body, Span<const double> phases)
      : parts_(model, body), phases_(phases) {}

  // Throw Status::kModel for words that mean nothing.
  QuantityPtr quantity(const std::string& text);
  Goal goal(const Clause& clause);
  Goal condition(const std::string& text) { return goal(read_clause(text)); }

  const Parts& parts() const { return parts_; }
  Span<const double> phases() const { return phases_; }
  // Room for numbers that are 0 when an episode begins.
  std::size_t keep(std::size_t count);
  std::size_t kept() const { return kept_; }

 private:
  Parts parts_;
  Span<const double> phases_;
  std::size_t kept_ = 0;
};

// A kind of quantity: its word, what follows it, and its maker, which gets what follows.
struct Kind {
  const char* word;
  const char* arguments;  // "PART AXIS"
  QuantityPtr (*make)(Maker& maker, const std::vector<std::string>& arguments);
};
Span<const Kind> present_kinds();     // measures.cpp
Span<const Kind> remembered_kinds();  // memories.cpp

}  // namespace mimo::tasks
