// What may be asked of growth.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "base/fail.h"
#include "growth/growth.h"

namespace mimo::test {
namespace {

using growth::Growth;

std::string refusal(const Growth& growth) {
  try {
    growth::check(growth);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kInvalidArgument);
    return error.message();
  }
  return "";
}

struct Number {
  double Growth::*member;
  const char* name;
  double least, most;
  const char* range;
};

const Number kNumbers[] = {
    {&Growth::age, "age", 0, 24, "expected 0 to 24 months"},
    {&Growth::physiological_age, "physiological_age", 0, 24, "expected 0 to 24 months"},
    {&Growth::z_length, "z_length", -3, 3, "expected -3 to 3 standard deviations"},
    {&Growth::z_weight, "z_weight", -3, 3, "expected -3 to 3 standard deviations"},
    {&Growth::z_head, "z_head", -3, 3, "expected -3 to 3 standard deviations"},
    {&Growth::strength_exponent, "strength_exponent", 0, 5, "expected 0 to 5"},
    {&Growth::neck_strength, "neck_strength", 0, 10, "expected 0 to 10"},
    {&Growth::birth_tone, "birth_tone", 0.1, 10, "expected 0.1 to 10"},
    {&Growth::contracture, "contracture", 0, 1, "expected 0 to 1"},
};

TEST(GrowthCheck, NamesTheNumberItsValueAndItsRange) {
  for (const Number& number : kNumbers) {
    SCOPED_TRACE(number.name);
    Growth growth;
    for (const double fine : {number.least, number.most}) {
      growth.*number.member = fine;
      EXPECT_EQ(refusal(growth), "");
    }
    for (const double bad : {std::nextafter(number.least, -100), std::nextafter(number.most, 100), std::nan("")}) {
      growth.*number.member = bad;
      const std::string message = refusal(growth);
      EXPECT_EQ(message.rfind(std::string(number.name) + " is ", 0), 0u) << message;
      EXPECT_NE(message.find(number.range), std::string::npos) << message;
    }
  }
}

TEST(GrowthCheck, ListsWhatTheOriginalDoesNotSupport) {
  Growth original;
  original.model = growth::Model::kOriginal;
  EXPECT_EQ(refusal(original), "");
  const auto expect_refused = [&](const char* name, const std::function<void(Growth&)>& change) {
    Growth growth = original;
    change(growth);
    EXPECT_EQ(refusal(growth).rfind(name, 0), 0u) << name << ": " << refusal(growth);
  };
  expect_refused("sex is 2", [](Growth& it) { it.sex = growth::Sex::kMale; });
  expect_refused("physiological_age is 18 and age 6", [](Growth& it) { it.age = 6; });
  expect_refused("z_length is 1", [](Growth& it) { it.z_length = 1; });
  expect_refused("z_weight is 1", [](Growth& it) { it.z_weight = 1; });
  expect_refused("z_head is 1", [](Growth& it) { it.z_head = 1; });
  expect_refused("absolute is 1", [](Growth& it) { it.absolute = true; });
}

// It comes before all else: there is no body at all here.
TEST(GrowthCheck, HappensBeforeReadingABody) {
  Growth growth;
  growth.age = 25;
  try {
    growth::grown({}, growth);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kInvalidArgument);
  }
}

TEST(GrowthCheck, SaysWhichPartOfABodyIsMissing) {
  for (const growth::Model model : {growth::Model::kWho, growth::Model::kOriginal}) {
    Growth growth;
    growth.model = model;
    try {
      growth::grown({}, growth);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::kUnsupported);
      EXPECT_NE(error.message().find('"'), std::string::npos) << error.message();
    }
  }
}

}  // namespace
}  // namespace mimo::test
