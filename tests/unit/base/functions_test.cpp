#include "base/functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <tuple>

#include "base/substitutes.h"

namespace mimo {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDigit = 4 * std::numeric_limits<double>::epsilon();  // two to four last digits

// The nearest numbers to what mpmath 1.3.0 gives with 300 bits.
TEST(Functions, AreTheNearestNumbers) {
  const struct {
    double (*function)(double);
    double x, expected;
  } rows[] = {
      // clang-format off
      {fixed::exp, 1.0, 0x1.5bf0a8b145769p+1},
      {fixed::exp, -0.3, 0x1.7b4c869c37c05p-1},
      {fixed::exp, 1e-09, 0x1.000000044b83p+0},
      {fixed::exp, 700.25, 0x1.2fd8e4cbfa413p+1010},
      {fixed::exp, -745.0, 0x0.0000000000001p-1022},
      {fixed::exp, 12.345, 0x1.c0d80ffb740c4p+17},
      {fixed::expm1, 1e-10, 0x1.b7cdfd9dda4e3p-34},
      {fixed::expm1, 0.003, 0x1.89ce712a56381p-9},
      {fixed::expm1, 0.5, 0x1.4c2531c3c0d38p-1},
      {fixed::expm1, -3.25, -0x1.ec25c97ade6fdp-1},
      {fixed::expm1, 30.0, 0x1.370470aec26edp+43},
      {fixed::exp2, 0.1, 0x1.125fbee250664p+0},
      {fixed::exp2, -0.7, 0x1.3b2c47bff8329p-1},
      {fixed::exp2, 123.456, 0x1.5f29e9ad54c6dp+123},
      {fixed::exp2, -1060.3, 0x0.00000000033fcp-1022},
      {fixed::log, 3.0, 0x1.193ea7aad030bp+0},
      {fixed::log, 0.99, -0x1.495453e6fd4bcp-7},
      {fixed::log, 1.0000001, 0x1.ad7f2847b6492p-24},
      {fixed::log, 1e-310, -0x1.64e69394d9508p+9},
      {fixed::log, 1e+300, 0x1.5963447f87fb5p+9},
      {fixed::log, 0.1, -0x1.26bb1bbb55515p+1},
      {fixed::log1p, 1e-12, 0x1.19799812de065p-40},
      {fixed::log1p, 1.5e-16, 0x1.59e05f1e2674dp-53},
      {fixed::log1p, 0.003, 0x1.88a09a34caacfp-9},
      {fixed::log1p, 0.7, 0x1.0fae81914a991p-1},
      {fixed::log1p, 1e+20, 0x1.7069e2aa2aa5bp+5},
      {fixed::log1p, -0.75, -0x1.62e42fefa39efp+0},
      {fixed::log2, 0.3, -0x1.bca9c6f53897bp+0},
      {fixed::log2, 7.0, 0x1.675767f54042dp+1},
      {fixed::log2, 1e-05, -0x1.09c1165ec0627p+4},
      {fixed::log2, 1.7e+30, 0x1.91b189e54ee64p+6},
      {fixed::log10, 0.3, -0x1.0bb6c34d81502p-1},
      {fixed::log10, 7.0, 0x1.b0b0b0b78cc3fp-1},
      {fixed::log10, 1e-05, -0x1.4p+2},
      {fixed::log10, 1.7e+30, 0x1.e3afeb354b7d9p+4},
      {fixed::cbrt, 0.3, 0x1.56bfea66ef78dp-1},
      {fixed::cbrt, 7.0, 0x1.e9b5dba58189ep+0},
      {fixed::cbrt, 1e-09, 0x1.0624dd2f1a9fcp-10},
      {fixed::cbrt, 27.0, 0x1.8p+1},
      {fixed::cbrt, 1.7e+30, 0x1.63af8a97a2fdcp+33},
      {fixed::sin, 0.7, 0x1.49d6e694619b8p-1},
      {fixed::sin, -2.5, -0x1.326af0dcfcab1p-1},
      {fixed::sin, 1e-05, 0x1.4f8b588e1e8a2p-17},
      {fixed::sin, 100.0, -0x1.03425b78c4db8p-1},
      {fixed::sin, 3.141592653589793, 0x1.1a62633145c07p-53},
      {fixed::sin, 22000.25, 0x1.455fa45428995p-2},
      {fixed::sin, 123456789.5, 0x1.df4f404fe0ff9p-1},
      {fixed::sin, 1000000000000000.0, 0x1.b76f88136cebap-1},
      {fixed::cos, 0.7, 0x1.87996529f9d93p-1},
      {fixed::cos, -2.5, -0x1.9a2f7ef858b7dp-1},
      {fixed::cos, 1e-05, 0x1.ffffffff920c8p-1},
      {fixed::cos, 100.0, 0x1.b981dbf665fdfp-1},
      {fixed::cos, 1.5707963267948966, 0x1.1a62633145c07p-54},
      {fixed::cos, 22000.25, -0x1.e5773c198c813p-1},
      {fixed::cos, 123456789.5, -0x1.68090105c433dp-2},
      {fixed::cos, 1000000000000000.0, -0x1.06c154609d33fp-1},
      {fixed::tan, 0.7, 0x1.af406c2fc78aep-1},
      {fixed::tan, -2.5, 0x1.7e79b4e00bb15p-1},
      {fixed::tan, 1e-05, 0x1.4f8b588e6698ep-17},
      {fixed::tan, 100.0, -0x1.2ca74d62b5d38p-1},
      {fixed::tan, 1.5, 0x1.c33ed50b88777p+3},
      {fixed::acos, 0.3, 0x1.441f5ecbeef59p+0},
      {fixed::acos, -0.8, 0x1.3fc176b7a856p+1},
      {fixed::acos, 0.9999999, 0x1.d4effc851e7f2p-12},
      {fixed::acos, -1.0, 0x1.921fb54442d18p+1},
      {fixed::acos, 1e-20, 0x1.921fb54442d18p+0},
      {fixed::asin, 0.3, 0x1.380159e14f6ffp-2},
      {fixed::asin, -0.8, -0x1.dac670561bb50p-1},
      {fixed::asin, 0.9999999, 0x1.920266447a7fap+0},
      {fixed::asin, 1e-05, 0x1.4f8b588e4e940p-17},
      {fixed::asin, 0.5000001, 0x1.0c152762b88dfp-1},
      {fixed::atan, 0.3, 0x1.2a73a661eaf06p-2},
      {fixed::atan, -0.8, -0x1.5977a5103ea93p-1},
      {fixed::atan, 0.0001, 0x1.a36e2e9a4f662p-14},
      {fixed::atan, 44.0, 0x1.8c4e82889748cp+0},
      {fixed::atan, -10000000000.0, -0x1.921fb543d4dep+0},
      {fixed::erfc, 0.3, 0x1.57be3bbf10af8p-1},
      {fixed::erfc, -0.8, 0x1.bdfa542dbfdc1p+0},
      {fixed::erfc, 2.5, 0x1.aab859b20ac9ep-12},
      // clang-format on
  };
  for (const auto& row : rows) EXPECT_EQ(row.function(row.x), row.expected) << "at " << row.x << " in " << &row - rows;
}

TEST(Functions, OfTwoNumbersAreTheNearestNumbers) {
  const struct {
    double (*function)(double, double);
    double x, y, expected;
  } rows[] = {
      // clang-format off
      {fixed::pow, 10.0, 0.3, 0x1.fec982d5bb8afp+0},
      {fixed::pow, 0.25, -1.7, 0x1.51cb453b9536cp+3},
      {fixed::pow, 1.0001, 5000.0, 0x1.a60fe569ca9d3p+0},
      {fixed::pow, 7.0, 350.0, 0x1.7d26eaed7a4e7p+982},
      {fixed::pow, -3.0, 5.0, -0x1.e6p+7},
      {fixed::pow, 1e-300, 0.01, 0x1.0624dd2f1a9fbp-10},
      {fixed::atan2, 1.0, 2.0, 0x1.dac670561bb4fp-2},
      {fixed::atan2, -3.0, -0.5, -0x1.bc66e44cbc074p+0},
      {fixed::atan2, 1e-08, -1.0, 0x1.921fb52ec942ap+1},
      {fixed::atan2, 5.0, 1e-12, 0x1.921fb54442994p+0},
      {fixed::atan2, 1e+300, -2e+299, 0x1.c4a83936311dap+0},
      // clang-format on
  };
  for (const auto& row : rows)
    EXPECT_EQ(row.function(row.x, row.y), row.expected) << "at " << row.x << ", " << row.y << " in " << &row - rows;
}

// As the C standard says in its annex F.
TEST(Functions, AreDefinedAtTheirEnds) {
  EXPECT_EQ(fixed::exp(-kInfinity), 0);
  EXPECT_EQ(fixed::exp(710), kInfinity);
  EXPECT_EQ(fixed::expm1(-kInfinity), -1);
  EXPECT_EQ(fixed::log(0), -kInfinity);
  EXPECT_EQ(fixed::log(kInfinity), kInfinity);
  EXPECT_EQ(fixed::log1p(-1), -kInfinity);
  EXPECT_TRUE(std::isnan(fixed::log(-1)));
  EXPECT_TRUE(std::isnan(fixed::sin(kInfinity)));
  EXPECT_TRUE(std::isnan(fixed::cos(-kInfinity)));
  EXPECT_TRUE(std::isnan(fixed::acos(1.5)));
  EXPECT_TRUE(std::isnan(fixed::asin(-1.5)));
  EXPECT_EQ(fixed::asin(-1), fixed::atan2(-1, 0));
  EXPECT_TRUE(std::signbit(fixed::asin(-0.0)));
  EXPECT_TRUE(std::signbit(fixed::sin(-0.0)));
  EXPECT_EQ(fixed::cbrt(0), 0);
  EXPECT_EQ(fixed::pow(0, -1), kInfinity);
  EXPECT_EQ(fixed::pow(-2, 3), -8);
  EXPECT_EQ(fixed::pow(-2, -2), 0.25);
  EXPECT_EQ(fixed::pow(2, 0x1p70), kInfinity);
  EXPECT_EQ(fixed::pow(0.5, 1e300), 0);
  EXPECT_TRUE(std::isnan(fixed::pow(-2, 0.5)));
  EXPECT_EQ(fixed::atan2(0, -1), fixed::acos(-1));
  EXPECT_EQ(fixed::atan2(-kInfinity, kInfinity), -fixed::atan(1));
  for (double (*function)(double) : {fixed::exp, fixed::log, fixed::sin, fixed::atan, fixed::erfc, fixed::log1p})
    EXPECT_TRUE(std::isnan(function(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Functions, SmallExponentialsAreGoodToTwoDigits) {
  for (float x = -87; x <= 0; x += 0.01F)
    EXPECT_NEAR(fixed::exp_of_negative(x) / std::exp(static_cast<double>(x)), 1, 4 * 0x1p-24) << x;
  EXPECT_EQ(fixed::exp_of_negative(0), 1);
}

TEST(Functions, TurnsAreThoseOfTheRightHand) {
  const double axis[] = {0, 0, 1};
  const auto [w, x, y, z] = turn_about<std::tuple<double, double, double, double>>(axis, std::acos(0.5));  // 60 degrees
  EXPECT_NEAR(w, std::sqrt(0.75), kDigit);
  EXPECT_NEAR(z, 0.5, kDigit);
  EXPECT_EQ(x, 0);
  EXPECT_EQ(y, 0);
}

TEST(Functions, QuotientsAreThoseOfComplexNumbers) {
  const std::complex<double> fifth = quotient({1, 2}, {3, -4});  // (1 + 2i)(3 + 4i) / 25
  EXPECT_NEAR(fifth.real(), -0.2, kDigit);
  EXPECT_NEAR(fifth.imag(), 0.4, kDigit);
}

}  // namespace
}  // namespace mimo
