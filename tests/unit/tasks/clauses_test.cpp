// How documents word behaviours.
#include "tasks/behaviour/clauses.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "base/fail.h"

namespace mimo::tasks {
namespace {

std::string refusal(const std::string& text) {
  try {
    read_clauses(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kModel);
    return error.message();
  }
  return "taken";
}

TEST(Clauses, AMeasureItsConditionsAndTheirTime) {
  const Clauses clauses = read_clauses(
      " tilt upper_body z  at most 30 from 90 deg;\n\tcontacts hands ground at least 2 parts; share (gaze toy at most "
      "5 "
      "deg) at least 0.5; for 2.5 s");
  ASSERT_EQ(clauses.all.size(), 3u);
  EXPECT_EQ(clauses.seconds, 2.5);
  const Clause& measure = clauses.all[0];
  EXPECT_EQ(measure.quantity, "tilt upper_body z");
  EXPECT_FALSE(measure.at_least);
  EXPECT_EQ(measure.threshold, 30);
  EXPECT_EQ(measure.from, std::optional<double>(90));
  EXPECT_EQ(measure.unit, "deg");
  EXPECT_TRUE(clauses.all[1].at_least);
  EXPECT_FALSE(clauses.all[1].from);
  EXPECT_EQ(clauses.all[2].quantity, "share (gaze toy at most 5 deg)");
  EXPECT_EQ(clauses.all[2].unit, "");
  EXPECT_EQ(measure.text, "tilt upper_body z at most 30 from 90 deg");
  EXPECT_EQ(clauses.all[2].text, "share (gaze toy at most 5 deg) at least 0.5");
}

TEST(Clauses, WithoutATimeAnInstantIsEnough) { EXPECT_EQ(read_clauses("height head at least 0.2 m").seconds, 0); }

template <typename Read>
std::string refused_time(Read&& read, const std::vector<double>& numbers) {
  try {
    read(numbers);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kModel);
    return error.message();
  }
  return "taken";
}

TEST(Clauses, TimesAreFiniteAndMoreThanZero) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const auto episode = [](const std::vector<double>& numbers) { episode_seconds(numbers); };
  const auto phases = [](const std::vector<double>& numbers) { phase_seconds(numbers); };
  EXPECT_EQ(episode_seconds({}), kUsualSeconds);
  EXPECT_EQ(episode_seconds(std::vector<double>{0.5}), 0.5);
  EXPECT_EQ(phase_seconds(std::vector<double>{2, 3}), (std::vector<double>{2, 3}));
  for (const double wrong : {0.0, -1.0, kNan, kInf}) {
    EXPECT_NE(refused_time(episode, {wrong}).find("mimo:episode_seconds: "), std::string::npos) << wrong;
    EXPECT_NE(refused_time(phases, {2, wrong}).find("mimo:phases: "), std::string::npos) << wrong;
  }
  EXPECT_EQ(refused_time(episode, {-1}), "mimo:episode_seconds: -1 s, expected a finite time of more than 0 s");
  EXPECT_EQ(refused_time(episode, {0.05, 0}), "mimo:episode_seconds: 2 numbers, 0.05 0, expected one time in s");
}

TEST(Clauses, WordsInParenthesesAreOneWord) {
  EXPECT_EQ(words_of("gain (times (a b) at least 1) 2 1"),
            (std::vector<std::string>{"gain", "times (a b) at least 1", "2", "1"}));
}

TEST(Clauses, WhatIsNotUnderstoodIsNamed) {
  for (const auto& [text, said] : {std::pair("", "nothing is measured"),
                                   {"height head", "\"at least\" or \"at most\""},
                                   {"at least 2 m", "expected a quantity"},
                                   {"height head at least", "and a number"},
                                   {"height head at least high m", "\"high\" stands where a number"},
                                   {"height head at least nan m", "\"nan\" stands where a number"},
                                   {"height head at least 1 m high", "\"high\" stands behind its end"},
                                   {"height head at least 1 from 2 m", "beyond the threshold"},
                                   {"tilt hip z at most 2 from 1 deg", "beyond the threshold"},
                                   {"height head at least 1 m; for 3", "\"for 10 s\""},
                                   {"height head at least 1 m; for -3 s", "below 0"},
                                   {"for 3 s; height head at least 1 m", "stand last"},
                                   {"times (height head at least 1 m at least 1 times", "\"(\" is not closed"},
                                   {"height head) at least 1 m", "\")\" closes nothing"}}) {
    EXPECT_NE(refusal(text).find(said), std::string::npos) << text << ": " << refusal(text);
  }
}

TEST(Clauses, ParenthesesAreNotNestedWithoutEnd) {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "change (";
    return text + "height head" + std::string(depth, ')') + " at least 1 m";
  };
  EXPECT_EQ(refusal(nested(16)), "taken");
  const std::string said = refusal(nested(100000));
  EXPECT_NE(said.find("more than 16 parentheses are open"), std::string::npos);
  EXPECT_LT(said.size(), 300u) << "a message has an end";
}

}  // namespace
}  // namespace mimo::tasks
