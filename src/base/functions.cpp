#include "base/functions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "base/substitutes.h"

namespace mimo::fixed {
namespace {

// ---- Pairs: sums of two numbers, of which the second is what rounding the sum leaves ----------------------------

struct Pair {
  double high, low;
};

// Of numbers of which the first is the larger one (T. J. Dekker, 1971).
constexpr Pair quick_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

constexpr Pair sum(double a, double b) {  // (D. E. Knuth)
  const double s = a + b, of_b = s - a;
  return {s, (a - (s - of_b)) + (b - of_b)};
}

// The first 53 - bits digits, for a factor of 2^bits + 1 (G. W. Veltkamp).
constexpr double first_digits(double x, double factor) {
  const double c = factor * x;
  return c - (c - x);
}
constexpr double kHalf = 0x1p27 + 1, kTop32 = 0x1p21 + 1;

constexpr Pair product(double a, double b) {
  const double p = a * b, a1 = first_digits(a, kHalf), b1 = first_digits(b, kHalf), a2 = a - a1, b2 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

constexpr Pair operator-(const Pair& a) { return {-a.high, -a.low}; }

constexpr Pair operator+(const Pair& a, const Pair& b) {
  const Pair s = sum(a.high, b.high), t = sum(a.low, b.low), u = quick_sum(s.high, s.low + t.high);
  return quick_sum(u.high, u.low + t.low);
}

constexpr Pair operator*(const Pair& a, const Pair& b) {
  const Pair p = product(a.high, b.high);
  return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

constexpr Pair operator/(const Pair& a, const Pair& b) {
  const double first = a.high / b.high;
  const Pair p = product(first, b.high);
  return quick_sum(first, (((a.high - p.high) - p.low) + a.low - first * b.low) / b.high);
}

constexpr Pair operator*(const Pair& a, double b) {
  const Pair p = product(a.high, b);
  return quick_sum(p.high, p.low + a.low * b);
}

constexpr Pair kLog2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr Pair kLog10 = {0x1.26bb1bbb55516p+1, -0x1.f48ad494ea3e9p-53};
constexpr Pair kPi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr double kPiRest = -0x1.f1976b7ed8fbcp-109;
constexpr Pair kRootsOfPi = {0x1.20dd750429b6dp+0, 0x1.1ae3a914fed80p-56};  // 2 / sqrt(pi)
constexpr Pair kOne = {1, 0};
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// ---- Tables, computed by the compiler --------------------------------------------------------------------------

// The sum of x^n / n! for n = first, first + step, ..., of which every second is taken away if signs change.
constexpr Pair series(const Pair& x, int first, int step, bool signs_change) {
  Pair term = first == 0 ? kOne : x, all = term;
  for (int n = first; n < 40; n += step) {
    for (int i = 1; i <= step; ++i) term = term * x / Pair{static_cast<double>(n + i), 0};
    if (signs_change) term = -term;
    all = all + term;
  }
  return all;
}

constexpr int kPowers = 64;  // 2^(i / 64)
constexpr std::array<Pair, kPowers> make_powers() {
  std::array<Pair, kPowers> table{};
  for (int i = 0; i < kPowers; ++i) table[i] = series(kLog2 * (i / 64.0), 0, 1, false);
  return table;
}
constexpr std::array<Pair, kPowers> kPower = make_powers();

// The number from 1/sqrt(2) to sqrt(2) with these first digits, times an inverse of few digits, is nearly 1.
constexpr int kFirstLog = 90, kLogs = 92;
constexpr double inverse_of(int i) {
  if (i == 127 || i == 128) return 1;
  return static_cast<double>(static_cast<int>(512 * 128 / (i + 0.5) + 0.5)) / 512;
}
struct Logarithm {
  double inverse;
  Pair of_rest;  // -log(inverse)
};
constexpr std::array<Logarithm, kLogs> make_logs() {  // log(c) = 2 artanh((c - 1) / (c + 1))
  std::array<Logarithm, kLogs> table{};
  for (int i = 0; i < kLogs; ++i) {
    const double inverse = inverse_of(kFirstLog + i);
    const Pair t = Pair{1 - inverse, 0} / Pair{1 + inverse, 0}, square = t * t;
    Pair power = t * 2, all = power;
    for (int n = 3; n < 43; n += 2) {
      power = power * square;
      all = all + power / Pair{static_cast<double>(n), 0};
    }
    table[i] = {inverse, all};
  }
  return table;
}
constexpr std::array<Logarithm, kLogs> kLog = make_logs();

constexpr int kQuarter = 64;  // parts of a quarter turn
constexpr std::array<Pair, kQuarter + 1> make_sines() {
  std::array<Pair, kQuarter + 1> table{};
  for (int i = 0; i <= kQuarter / 2; ++i) {
    const Pair angle = kPi * (i / 128.0);
    table[i] = i == 0 ? Pair{0, 0} : series(angle, 1, 2, true);
    table[kQuarter - i] = series(angle, 0, 2, true);
  }
  return table;
}
constexpr std::array<Pair, kQuarter + 1> kSine = make_sines();

// atan(i / 64), from one to the next by what lies between: tan(a - b) = (tan a - tan b) / (1 + tan a tan b).
constexpr int kAngles = 64;
constexpr std::array<Pair, kAngles + 1> make_angles() {
  std::array<Pair, kAngles + 1> table{};
  for (int i = 1; i <= kAngles; ++i) {
    const Pair t = Pair{64, 0} / Pair{4096.0 + i * (i - 1), 0}, square = t * t;
    Pair power = t, all = t;
    for (int n = 3; n < 21; n += 2) {
      power = -(power * square);
      all = all + power / Pair{static_cast<double>(n), 0};
    }
    table[i] = table[i - 1] + all;
  }
  return table;
}
constexpr std::array<Pair, kAngles + 1> kAngle = make_angles();

// ---- Parts ------------------------------------------------------------------------------------------------------

// To the nearest integer, of numbers below 2^51.
double rounded(double x) {
  constexpr double kNoFractions = 0x1.8p52;
  return (x + kNoFractions) - kNoFractions;
}

std::uint64_t bits_of(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

double number_of(std::uint64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// 2 to the n, from -1022 to 1023.
double power_of_2(int n) { return number_of(static_cast<std::uint64_t>(n + 1023) << 52); }

// x times 2 to the n. What is smaller than a normal number is rounded once.
double scaled(double x, int n) { return x * power_of_2(n / 2) * power_of_2(n - n / 2); }

struct Exponential {
  Pair part;
  int power;  // of 2
};

// Of numbers from -800 to 800.
Exponential exponential(const Pair& x) {
  constexpr double kStep = kLog2.high / kPowers, kFirst = first_digits(kStep, kTop32);
  constexpr double kRest = (kStep - kFirst) + kLog2.low / kPowers;
  const double steps = rounded(x.high * (1 / kStep));
  const Pair left = sum(x.high - steps * kFirst, -steps * kRest), r = quick_sum(left.high, left.low + x.low);
  const double h = r.high;
  const double more =
      h * h * (0.5 + h * (1.0 / 6 + h * (1.0 / 24 + h * (1.0 / 120 + h * (1.0 / 720 + h * (1.0 / 5040))))));
  const int count = static_cast<int>(steps), i = count & (kPowers - 1);
  const Pair& t = kPower[i];
  const Pair p = product(t.high, h), s = quick_sum(t.high, p.high);
  return {quick_sum(s.high, s.low + (p.low + (t.low + t.low * h + t.high * (r.low + more)))), (count - i) / kPowers};
}

double exponential_number(const Pair& x) {
  if (x.high > 800) return kInfinity;
  if (x.high < -800) return 0;
  const Exponential e = exponential(x);
  return scaled(e.part.high, e.power);
}

// log(1 + r) + known, of r below 2^-7.
Pair log_near(const Pair& known, const Pair& r) {
  const double h = r.high;
  const Pair square = product(h, h), a = sum(known.high, h), b = sum(a.high, -0.5 * square.high);
  const double series =
      1.0 / 3 +
      h * (-1.0 / 4 +
           h * (1.0 / 5 +
                h * (-1.0 / 6 + h * (1.0 / 7 + h * (-1.0 / 8 + h * (1.0 / 9 + h * (-1.0 / 10 + h * (1.0 / 11))))))));
  const double small = (known.low + (r.low - h * r.low)) - 0.5 * square.low + h * square.high * series;
  return quick_sum(b.high, b.low + (a.low + small));
}

// Of numbers that are greater than 0 and finite.
Pair logarithm(double x) {
  int power = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    power = -54;
  }
  const std::uint64_t bits = bits_of(x), fraction = bits & 0xfffffffffffffU;
  power += static_cast<int>(bits >> 52) - 1023;
  double z = number_of(fraction | 0x3ff0000000000000U);
  if (fraction > 0x6a09e667f3bccU) {  // of sqrt(2)
    z *= 0.5;
    ++power;
  }
  constexpr double kFirst = first_digits(kLog2.high, kTop32), kRest = (kLog2.high - kFirst) + kLog2.low;
  const auto& [inverse, of_rest] = kLog[static_cast<int>(z * 128) - kFirstLog];
  const double top = number_of(bits_of(z) & ~std::uint64_t{0x1fffff});  // times the inverse it needs no rounding
  Pair known = sum(power * kFirst, of_rest.high);
  known.low += of_rest.low + power * kRest;
  return log_near(known, sum(top * inverse - 1, (z - top) * inverse));
}

// Whether log(x) needs no computing, and then what it is.
bool plain_logarithm(double x, double& result) {
  if (x > 0 && x < kInfinity) return false;
  result = x == 0 ? -kInfinity : x > 0 ? x : kNoNumber;
  return true;
}

double log_to(double x, const Pair& per_base) {
  double plain;
  return plain_logarithm(x, plain) ? plain : (logarithm(x) * per_base).high;
}

// The sine of the i-th part of a turn of 256.
Pair sine_of(int i) {
  const int quarter = i / kQuarter & 3, rest = i & (kQuarter - 1);
  const Pair& sine = kSine[quarter & 1 ? kQuarter - rest : rest];
  return quarter & 2 ? -sine : sine;
}

struct Angle {
  Pair rest;
  int part;  // of 256
};

// By numbers of turns, of numbers up to 2^50.
Pair without_turns(double x) {
  const double turns = rounded(x / (2 * kPi.high));
  const Pair first = product(turns, 2 * kPi.high), second = product(turns, 2 * kPi.low);
  const Pair rest = sum(x, -first.high) + Pair{-first.low, 0} + -second;
  return rest + Pair{-turns * (2 * kPiRest), 0};
}

Angle angle_of(double x) {
  constexpr double kLarge = 0x1p15, kMeaningless = 0x1p50;  // where no two numbers lie within a quarter of a radian
  constexpr double kStep = kPi.high / 128, kFirst = first_digits(kStep, kTop32);
  constexpr double kSecond = first_digits((kStep - kFirst) + kPi.low / 128, kTop32);
  constexpr double kRest = (((kStep - kFirst) - kSecond) + kPi.low / 128) + kPiRest / 128;
  Pair all{x, 0};
  if (std::abs(x) > kMeaningless)
    all.high = std::fmod(x, kPi.high);
  else if (std::abs(x) > kLarge)
    all = without_turns(x);
  const double parts = rounded(all.high * (1 / kStep));
  Pair rest = sum(all.high - parts * kFirst, -parts * kSecond);
  rest.low += all.low - parts * kRest;
  return {quick_sum(rest.high, rest.low), static_cast<int>(parts) & 255};
}

// The sine of an angle and so many further parts.
Pair sine(const Angle& angle, int further) {
  const Pair s = sine_of(angle.part + further), c = sine_of(angle.part + further + kQuarter);
  const double r = angle.rest.high, low = angle.rest.low, square = r * r;
  const double cosine_less = square * (-0.5 + square * (1.0 / 24 + square * (-1.0 / 720 + square * (1.0 / 40320))));
  const double sine_less = r * square * (-1.0 / 6 + square * (1.0 / 120 + square * (-1.0 / 5040)));
  const Pair p = product(c.high, r), all = sum(s.high, p.high);
  const double small = p.low + (s.low + c.low * r + low * (c.high - s.high * r));
  return quick_sum(all.high, all.low + (small + (s.high * cosine_less + c.high * sine_less)));
}

constexpr double kTiny = 0x1p-27;  // sin(x), tan(x) and atan(x) of less are x

// Of lengths that are not negative, not both 0 and neither huge nor tiny: the angle in the first quarter.
Pair quarter_angle(const Pair& y, const Pair& x) {
  const bool steep = y.high > x.high;
  const Pair &shorter = steep ? x : y, &longer = steep ? y : x;
  const int i = static_cast<int>(shorter.high / longer.high * kAngles + 0.5);
  const double c = static_cast<double>(i) / kAngles;
  const Pair t = (shorter + longer * -c) / (longer + shorter * c);
  const double square = t.high * t.high;
  const double series = -1.0 / 3 + square * (1.0 / 5 + square * (-1.0 / 7 + square * (1.0 / 9)));
  const Pair& known = kAngle[i];
  const Pair s = sum(known.high, t.high);
  const Pair angle = quick_sum(s.high, s.low + (known.low + t.low + t.high * square * series));
  return steep ? kPi * 0.5 + -angle : angle;
}

// Of a point that is not the origin, whose x is not negative if it is a pair.
double whole_angle(const Pair& y, double x) {
  const Pair angle = quarter_angle(y, {std::abs(x), 0});
  return x < 0 ? (kPi + -angle).high : angle.high;
}

// Of a triangle with a right angle, whose longest side is 1: sqrt(1 - x^2).
Pair other_leg(double x) {
  const Pair square = product(x, x), left = sum(1, -square.high) + Pair{-square.low, 0};
  const double root = std::sqrt(left.high);
  if (root == 0) return {0, 0};
  const Pair of_root = product(root, root);
  return quick_sum(root, ((left.high - of_root.high) - of_root.low + left.low) / (2 * root));
}

// Both numbers times the power of 2 that brings the larger one near 1.
double near_1(double x, double larger) {
  const int power = static_cast<int>(bits_of(larger) >> 52) - 1023;
  return scaled(x, -power);
}

}  // namespace

// ---- Exponentials -----------------------------------------------------------------------------------------------

double exp(double x) { return std::isnan(x) ? x : exponential_number({x, 0}); }

double expm1(double x) {
  if (std::isnan(x) || std::abs(x) < 0x1p-54) return x;
  if (std::abs(x) < 0x1p-8) {
    return x + x * x * (0.5 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720 + x * (1.0 / 5040))))));
  }
  if (std::abs(x) > 700) return exp(x) - 1;
  const Exponential e = exponential({x, 0});
  const Pair less = sum(scaled(e.part.high, e.power), -1);
  return less.high + (less.low + scaled(e.part.low, e.power));
}

double exp2(double x) {
  if (std::isnan(x)) return x;
  return exponential_number(std::abs(x) < 1100 ? kLog2 * x : Pair{x, 0});
}

// ---- Logarithms and powers --------------------------------------------------------------------------------------

double log(double x) {
  double plain;
  return plain_logarithm(x, plain) ? plain : logarithm(x).high;
}

double log2(double x) {
  constexpr Pair kPerLog2 = kOne / kLog2;
  return log_to(x, kPerLog2);
}

double log10(double x) {
  constexpr Pair kPerLog10 = kOne / kLog10;
  return log_to(x, kPerLog10);
}

double log1p(double x) {
  double plain;
  if (std::abs(x) < 0x1p-54) return x;
  if (plain_logarithm(1 + x, plain)) return plain;
  if (std::abs(x) < 0x1p-8) return log_near({0, 0}, {x, 0}).high;
  const Pair whole = sum(1, x), known = logarithm(whole.high);
  return known.high + (known.low + whole.low / whole.high);
}

double pow(double x, double y) {
  constexpr double kHuge = 0x1p64;  // numbers of this size are even
  const double size = std::abs(x);
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return kNoNumber;
  double result;
  if (size == 0 || size == kInfinity) {
    result = (size == 0) == (y < 0) ? kInfinity : 0;
  } else if (std::abs(y) >= kHuge) {  // x is no number near enough to 1 for anything in between
    result = size == 1 ? 1 : (size > 1) == (y > 0) ? kInfinity : 0;
  } else {
    result = exponential_number(logarithm(size) * y);
  }
  if (!std::signbit(x)) return result;
  if (std::abs(y) < kHuge && y != std::floor(y)) return size > 0 && size < kInfinity ? kNoNumber : result;
  return std::abs(y) < kHuge && std::fmod(y, 2) != 0 ? -result : result;
}

double cbrt(double x) {
  if (!(x > 0 && x < kInfinity)) return x;
  constexpr Pair kThird = kOne / Pair{3, 0};
  return exponential_number(logarithm(x) * kThird);
}

// ---- Angles -----------------------------------------------------------------------------------------------------

double sin(double x) {
  if (!std::isfinite(x)) return kNoNumber;
  return std::abs(x) < kTiny ? x : sine(angle_of(x), 0).high;
}

double cos(double x) { return std::isfinite(x) ? sine(angle_of(x), kQuarter).high : kNoNumber; }

double tan(double x) {
  if (!std::isfinite(x)) return kNoNumber;
  if (std::abs(x) < kTiny) return x;
  const Angle angle = angle_of(x);
  return (sine(angle, 0) / sine(angle, kQuarter)).high;
}

double acos(double x) {
  if (!(std::abs(x) <= 1)) return kNoNumber;
  const Pair leg = other_leg(x);
  if (leg.high == 0) return x > 0 ? 0 : kPi.high;
  return whole_angle(leg, x);
}

double asin(double x) {
  if (!(std::abs(x) <= 1)) return kNoNumber;
  if (std::abs(x) < kTiny) return x;
  const Pair leg = other_leg(x);
  return std::copysign(leg.high == 0 ? kPi.high / 2 : quarter_angle({std::abs(x), 0}, leg).high, x);
}

double atan(double x) { return std::abs(x) < kTiny ? x : atan2(x, 1); }

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNoNumber;
  double high = std::abs(y), wide = std::abs(x);
  if (high == kInfinity || wide == kInfinity) {
    high = high == kInfinity ? 1 : 0;
    wide = wide == kInfinity ? 1 : 0;
  }
  const double larger = std::max(high, wide);
  double angle = std::signbit(x) ? kPi.high : 0;
  if (high > 0) {
    const double width = near_1(wide, larger);
    angle = whole_angle({near_1(high, larger), 0}, x < 0 ? -width : width);
  }
  return std::copysign(angle, y);
}

// ---- Probability ------------------------------------------------------------------------------------------------

// 1 - 2 / sqrt(pi) exp(-x^2) (x + 2 x^3 / 3 + 4 x^5 / 15 + ...), whose terms have one sign.
double erfc(double x) {
  const Pair square = product(x, x), twice = square * 2;
  if (!(square.high < 36)) return std::isnan(x) ? x : x > 0 ? 0 : 2;
  Pair term{x, 0}, all = term;
  for (int n = 3; std::abs(term.high) > 0x1p-110 * std::abs(all.high); n += 2) {
    term = term * twice / Pair{static_cast<double>(n), 0};
    all = all + term;
  }
  const Exponential e = exponential(-square);
  const Pair falling{scaled(e.part.high, e.power), scaled(e.part.low, e.power)};
  return (kOne + -(kRootsOfPi * (falling * all))).high;
}

}  // namespace mimo::fixed
