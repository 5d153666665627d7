// Reflexes by themselves: ages, latencies, the course of one, habituation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reflexes/arc.h"
#include "reflexes/pattern.h"
#include "reflexes/table.h"

namespace mimo::reflexes {
namespace {

constexpr double kTick = 0.005;

const Reflex kAll[] = {Reflex::kPalmarGrasp, Reflex::kPlantarGrasp, Reflex::kRooting,   Reflex::kMoro,
                       Reflex::kTonicNeck,   Reflex::kStepping,     Reflex::kWithdrawal};

// Drives an arc with a stimulus and gives its activation, tick by tick.
std::vector<double> course(Arc& arc, double stimulus, double seconds) {
  std::vector<double> activations;
  for (int i = 0; i < std::lround(seconds / kTick); ++i) {
    arc.advance(stimulus);
    activations.push_back(arc.activation());
  }
  return activations;
}

double peak(const std::vector<double>& activations) {
  return *std::max_element(activations.begin(), activations.end());
}

// A stimulus of 0.2 s, then rest: how strong the reflex became.
double poke(Arc& arc, double period) {
  const double during = peak(course(arc, 2, 0.2));
  return std::max(during, peak(course(arc, 0, period - 0.2)));
}

// Weeks from conception at which it starts, months at which the latest of its sources lets it end; the earliest one.
TEST(Reflexes, ActWithinTheirAgesOnly) {
  const struct {
    Reflex reflex;
    double start_weeks, full_until, over_by;
  } ages[] = {{Reflex::kPalmarGrasp, 25, 2, 6}, {Reflex::kPlantarGrasp, 25, 5, 12}, {Reflex::kMoro, 30, 2, 5},
              {Reflex::kTonicNeck, 40, 4, 8},   {Reflex::kStepping, 38, 0.5, 2},    {Reflex::kRooting, 28, 2, 4}};
  for (const auto& [reflex, start, full, over] : ages) {
    const Rule& its = rule(reflex);
    const double born = (start - 40) * 7 / 30.4375;
    EXPECT_EQ(gain(its, born - 0.01), 0) << its.name;
    EXPECT_EQ(gain(its, born + 0.01), 1) << its.name;
    EXPECT_EQ(gain(its, full), 1) << its.name;
    EXPECT_EQ(gain(its, over), 0) << its.name;
    EXPECT_EQ(gain(its, 24), 0) << its.name;
  }
  EXPECT_EQ(gain(rule(Reflex::kWithdrawal), 24), 1);
}

TEST(Reflexes, FadeInTheirLastMonth) {
  const Rule& moro = rule(Reflex::kMoro);
  EXPECT_EQ(gain(moro, moro.end - 1), 1);
  EXPECT_NEAR(gain(moro, moro.end - 0.25), 0.25, 1e-12);
}

// Newborns conduct at 24.5 m/s; a foot that is 0.49 m from the brain stem: 20 ms there, 20 ms back, 12 ms in the cord.
TEST(Reflexes, ANewbornsFootIsWithdrawnAfter52Milliseconds) {
  const growth::Conduction nerves = growth::conduction_at(0);
  EXPECT_NEAR(latency(rule(Reflex::kWithdrawal), nerves, 0.49, 0.49), 0.052, 0.0005);
  // Through the brain stem: 20 to 30 ms there.
  const double neck = latency(rule(Reflex::kTonicNeck), nerves, 0, 0);
  EXPECT_GE(neck, 0.020);
  EXPECT_LE(neck, 0.030);
}

// Kuhne et al. 2012: medians of 1.2 g at 3 days and 4.6 g at a year; between them the fit of the facts, 16.5 and 23.1
// mN.
TEST(Reflexes, ThresholdOfWithdrawalRisesWithAge) {
  EXPECT_NEAR(withdrawal_force(0), 1.2e-3 * 9.81, 1e-4);
  EXPECT_NEAR(withdrawal_force(3), 0.0165, 1e-4);
  EXPECT_NEAR(withdrawal_force(6), 0.0231, 1e-4);
  EXPECT_NEAR(withdrawal_force(12), 4.6e-3 * 9.81, 1e-4);
  EXPECT_EQ(withdrawal_force(24), withdrawal_force(12));
  const double known[][2] = {{0, 11.8}, {3, 16.5}, {6, 23.1}, {12, 45.1}, {24, 45.1}};
  for (const auto& [months, millinewton] : known) {
    EXPECT_NEAR(withdrawal_force(months) * 1e3, millinewton, 0.05) << months;
  }
}

// Cornelissen et al. 2013: both legs alike in newborns.
TEST(Reflexes, MoveTheOtherLegInNewborns) {
  EXPECT_EQ(crossed(0), 1);
  EXPECT_EQ(crossed(6), 0);
}

TEST(Reflexes, DoNothingBelowTheThreshold) {
  for (const Reflex reflex : kAll) {
    Arc arc(rule(reflex), 10, kTick);
    EXPECT_EQ(peak(course(arc, 0.999, 5)), 0) << rule(reflex).name;
  }
}

TEST(Reflexes, BeginAfterTheirLatencyToTheTick) {
  for (const std::size_t latency : {std::size_t{0}, std::size_t{1}, std::size_t{10}}) {
    for (const Reflex reflex : kAll) {
      Arc arc(rule(reflex), latency, kTick);
      const std::vector<double> activations = course(arc, 1, 1);
      for (std::size_t i = 0; i < latency; ++i) EXPECT_EQ(activations[i], 0) << rule(reflex).name;
      EXPECT_GT(activations[latency], 0) << rule(reflex).name;
      EXPECT_NEAR(activations[latency + 19], 1, 1e-9) << rule(reflex).name;  // risen within 0.1 s
      EXPECT_LT(activations[latency + 18], 1) << rule(reflex).name;
    }
  }
}

// A stimulus that stays gives one reflex: those that are phasic end by themselves, the tonic ones with the stimulus.
TEST(Reflexes, ActOncePerStimulus) {
  for (const Reflex reflex : kAll) {
    const Rule& its = rule(reflex);
    Arc arc(its, 10, kTick);
    int begun = 0;
    double before = 0;
    for (const double activation : course(arc, 1, 20)) {
      if (before == 0 && activation > 0) ++begun;
      before = activation;
    }
    EXPECT_EQ(begun, 1) << its.name;
    EXPECT_EQ(before, its.tonic ? 1 : 0) << its.name;
    const std::vector<double> after = course(arc, 0, 0.05 + its.decay + 0.01);
    EXPECT_EQ(after.back(), 0) << its.name;
    EXPECT_EQ(after[9], its.tonic ? 1 : 0) << its.name << ": news of the end are as late as those of the beginning";
  }
}

// Once begun it runs its course: stimuli in between neither begin it anew nor count as repeats.
TEST(Reflexes, RunTheirCourse) {
  Arc moro(rule(Reflex::kMoro), 10, kTick);
  course(moro, 1, 0.1);
  course(moro, 0, 0.4);
  const std::vector<double> again = course(moro, 1, 0.1), after = course(moro, 0, 3);
  EXPECT_EQ(again.back(), 1);
  EXPECT_NEAR(moro.seconds(), 0.1 + rule(Reflex::kMoro).hold + rule(Reflex::kMoro).decay, 0.011);
  EXPECT_NEAR(poke(moro, 3), 0.8, 1e-9) << "the second, not the third";
}

TEST(Reflexes, TreatAFlickeringStimulusAsOne) {
  Arc arc(rule(Reflex::kWithdrawal), 10, kTick);
  for (int i = 0; i < 2000; ++i) arc.advance(i % 10 == 0 ? 1 : 0);
  EXPECT_EQ(arc.activation(), 0);
}

// 45 degrees set the tonic neck reflex off, 30 still keep it up, 29 do not.
TEST(Reflexes, EndBelowALowerThreshold) {
  Arc arc(rule(Reflex::kTonicNeck), 5, kTick);
  course(arc, 45.0 / 45, 1);
  EXPECT_EQ(course(arc, 30.1 / 45, 2).back(), 1);
  EXPECT_EQ(course(arc, 29.0 / 45, 2).back(), 0);
  EXPECT_EQ(peak(course(arc, 44.0 / 45, 2)), 0);
}

// 0.8 a repeat within 10 s; all as new 30 s after the last one.
TEST(Reflexes, HabituateAndRecover) {
  Arc arc(rule(Reflex::kWithdrawal), 10, kTick);
  for (const double expected : {1.0, 0.8, 0.64, 0.512}) EXPECT_NEAR(poke(arc, 5), expected, 1e-9);
  course(arc, 0, 26);
  EXPECT_NEAR(poke(arc, 5), 1, 1e-9);
  EXPECT_NEAR(poke(arc, 20), 0.8, 1e-9);
  EXPECT_NEAR(poke(arc, 5), 0.9, 1e-3);  // half way between 10 and 30 s
  arc.rest();
  EXPECT_NEAR(poke(arc, 5), 1, 1e-9);
}

TEST(Reflexes, ContinueExactlyFromASavedState) {
  Arc one(rule(Reflex::kMoro), 10, kTick), other(rule(Reflex::kMoro), 10, kTick);
  poke(one, 3);
  course(one, 2, 0.03);  // on its way
  std::vector<std::uint8_t> bytes(200);
  ByteWriter to{Span<std::uint8_t>(bytes)};
  one.save(to);
  ByteReader from{Span<const std::uint8_t>(bytes.data(), to.size())};
  other.load(from);
  EXPECT_EQ(course(one, 2, 3), course(other, 2, 3));
  ByteReader half{Span<const std::uint8_t>(bytes.data(), 5)};
  EXPECT_ANY_THROW(other.load(half));
}

TEST(Reflexes, LeftAndRightAreMirrored) {
  for (const Reflex reflex : kAll) {
    for (const Pull& pull : pattern(reflex)) {
      const std::string left = motor_name(pull, Side::kLeft), right = motor_name(pull, Side::kRight);
      const double ours = share(pull, Side::kLeft, 0.2, 0), theirs = share(pull, Side::kRight, 0.2, 0);
      if (pull.limb == Limb::kMiddle) {
        EXPECT_EQ(left, right);
        EXPECT_EQ(ours, -theirs);
      } else {
        EXPECT_NE(left.find(pull.limb == Limb::kOwn ? "left" : "right"), std::string::npos);
        EXPECT_NE(right.find(pull.limb == Limb::kOwn ? "right" : "left"), std::string::npos);
        EXPECT_EQ(ours, theirs);
      }
    }
  }
}

// Moro: arms first open, then close.
TEST(Reflexes, MoroHasTwoPhases) {
  for (const Pull& pull : pattern(Reflex::kMoro)) {
    const bool opens = pull.phase == Phase::kFirst;
    EXPECT_EQ(share(pull, Side::kLeft, 0.2, 0), opens ? pull.share : 0);
    EXPECT_EQ(share(pull, Side::kLeft, 0.8, 0), opens ? 0 : pull.share);
  }
}

TEST(Reflexes, LegsTakeTurns) {
  for (double seconds = 0; seconds < 3; seconds += 0.05) {
    EXPECT_EQ(std::min(swing(seconds, true), swing(seconds, false)), 0) << seconds;
  }
  EXPECT_GT(swing(0.3, true), 0.9);
  EXPECT_GT(swing(0.9, false), 0.9);
}

}  // namespace
}  // namespace mimo::reflexes
