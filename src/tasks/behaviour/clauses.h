// A behaviour as its scene's document words it: what is measured, what it has to reach, for how long.
//
//   behaviour = clause { ";" clause } [ ";" "for" NUMBER "s" ]
//   clause    = quantity ("at least" | "at most") NUMBER [ "from" NUMBER ] [ UNIT ]
//   quantity  = WORD { WORD | NUMBER | "(" quantity or clause ")" }
//
// The first clause is the behaviour's measure, the others are conditions. The behaviour is shown when all hold together
// for that time. Nothing here knows a model: what the words of a quantity mean, measures.h says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/span.h"

namespace mimo::tasks {

struct Clause {
  std::string text;      // "tilt upper_body z at most 30 from 90 deg": the whole, with single spaces
  std::string quantity;  // "tilt upper_body z"
  bool at_least = true;
  double threshold = 0;
  std::optional<double> from;  // where progress towards the threshold begins; nothing: progress is all or nothing
  std::string unit;            // "": a plain number

  // Whether progress begins before the threshold.
  bool leads_up() const { return at_least ? *from < threshold : *from > threshold; }
};

// Of an episode, where a document says nothing.
inline constexpr double kUsualSeconds = 10;

struct Clauses {
  std::vector<Clause> all;  // at least one
  double seconds = 0;       // for which all have to hold
};

// Throws Status::kModel, with the words that it did not understand.
Clauses read_clauses(const std::string& text);
// One clause, as in the parentheses of a quantity.
Clause read_clause(const std::string& text);

// The words of a quantity: what stands in parentheses is one of them, without these.
std::vector<std::string> words_of(const std::string& quantity);

// How long an episode lasts and its phases last, s, by the numbers of a document's entry; none: it has no such entry.
// Throw Status::kModel for what is no time.
double episode_seconds(Span<const double> numbers);
std::vector<double> phase_seconds(Span<const double> numbers);

// A word that has to be a number.
double number_of(const std::string& word, const std::string& of);

}  // namespace mimo::tasks
