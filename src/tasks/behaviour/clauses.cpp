#include "tasks/behaviour/clauses.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"

namespace mimo::tasks {
namespace {

using Words = std::vector<std::string>;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  constexpr std::size_t kShown = 200;
  const std::string shown = text.size() > kShown ? text.substr(0, kShown) + "..." : text;
  fail(Status::kModel, "{}: \"{}\": {}", names::kReached, shown, why);
}

constexpr int kDeepest = 16;  // parentheses within each other; quantities are made by recursion

// Parts between separators that stand in no parentheses.
template <typename Separates>
Words split(const std::string& text, Separates&& separates) {
  Words parts{""};
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth < 0) refuse(text, "a \")\" closes nothing");
    if (depth > kDeepest) refuse(text, format("more than {} parentheses are open", kDeepest));
    if (depth == 0 && separates(c)) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (depth > 0) refuse(text, "a \"(\" is not closed");
  return parts;
}

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

Words words_in(const std::string& text) {
  Words words = split(text, is_space);
  words.erase(std::remove(words.begin(), words.end(), ""), words.end());
  return words;
}

// Of words from one to another.
std::string joined(const Words& words, std::size_t from, std::size_t to) {
  const auto at = [&](std::size_t i) { return words.begin() + static_cast<std::ptrdiff_t>(i); };
  return join(Words(at(from), at(to)), " ");
}

bool is_number(const std::string& word, double& value) {
  const char* end = word.data() + word.size();
  const std::from_chars_result read = read_double(word.data(), end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value);
}

// Where "at least" or "at most" begins; the number of words where nothing does.
std::size_t comparison_in(const Words& words) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == "at" && (words[i + 1] == "least" || words[i + 1] == "most")) return i;
  }
  return words.size();
}

Clause clause_of(const Words& words, const std::string& text) {
  const std::size_t at = comparison_in(words);
  if (at == 0 || at + 2 >= words.size()) {
    refuse(text,
           "expected a quantity, then \"at least\" or \"at most\" and a number, as in \"height head at least 0.2 m\"");
  }
  Clause clause;
  clause.text = joined(words, 0, words.size());
  clause.quantity = joined(words, 0, at);
  clause.at_least = words[at + 1] == "least";
  clause.threshold = number_of(words[at + 2], text);
  std::size_t next = at + 3;
  if (next + 1 < words.size() && words[next] == "from") {
    clause.from = number_of(words[next + 1], text);
    next += 2;
    if (!clause.leads_up()) refuse(text, "progress begins beyond the threshold");
  }
  if (next < words.size()) clause.unit = words[next++];
  if (next < words.size()) refuse(text, "\"" + words[next] + "\" stands behind its end");
  return clause;
}

void require_time(const char* entry, double seconds) {
  if (std::isfinite(seconds) && seconds > 0) return;
  fail(Status::kModel, "{}: {} s, expected a finite time of more than 0 s", entry, seconds);
}

}  // namespace

double episode_seconds(Span<const double> numbers) {
  if (numbers.empty()) return kUsualSeconds;
  if (numbers.size() != 1) {
    fail(Status::kModel, "{}: {} numbers, {}, expected one time in s", names::kSeconds, numbers.size(),
         join(numbers, " "));
  }
  require_time(names::kSeconds, numbers[0]);
  return numbers[0];
}

std::vector<double> phase_seconds(Span<const double> numbers) {
  for (const double seconds : numbers) require_time(names::kPhases, seconds);
  return {numbers.begin(), numbers.end()};
}

double number_of(const std::string& word, const std::string& of) {
  double value = 0;
  if (!is_number(word, value)) refuse(of, "\"" + word + "\" stands where a number is expected");
  return value;
}

std::vector<std::string> words_of(const std::string& quantity) {
  Words words = words_in(quantity);
  for (std::string& word : words) {
    if (word.front() == '(' && word.back() == ')') word = word.substr(1, word.size() - 2);
  }
  return words;
}

Clause read_clause(const std::string& text) { return clause_of(words_in(text), text); }

Clauses read_clauses(const std::string& text) {
  Clauses clauses;
  bool ended = false;
  for (const std::string& part : split(text, [](char c) { return c == ';'; })) {
    const Words words = words_in(part);
    if (words.empty()) continue;
    if (ended) refuse(text, "\"for\" and its seconds stand last");
    ended = words[0] == "for";
    if (!ended) {
      clauses.all.push_back(clause_of(words, part));
      continue;
    }
    if (words.size() != 3 || words[2] != "s") refuse(text, "expected \"for\", a number and \"s\", as in \"for 10 s\"");
    clauses.seconds = number_of(words[1], text);
    if (clauses.seconds < 0) refuse(text, "a time is below 0");
  }
  if (clauses.all.empty()) refuse(text, "nothing is measured");
  return clauses;
}

}  // namespace mimo::tasks
