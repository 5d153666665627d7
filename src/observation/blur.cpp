#include "observation/blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/functions.h"
#include "base/numbers.h"
#include "base/processor.h"

namespace mimo::observation {
namespace {

constexpr double kFitted = 1.1;     // pixels: wider Gaussians can be sampled
constexpr double kReach = 3.5;      // sampled up to so many sigma
constexpr double kWidest = 140;     // pixels: little is left of any picture
constexpr std::size_t kBeside = 3;  // weights beside the middle

// A number that the last bit of a library's exp or cos cannot change. Twice as much in whole 65536ths is what a row is
// weighed with.
double rounded(double weight) { return std::round(weight * 131072) / 131072; }

// Samples of a narrow Gaussian leave far too much (0.3 too much at 0.3 pixels). These weights are those of least
// squares over all frequencies that pixels can hold. The sum is to be 1, so they are fitted to what is lost: each takes
// away 2 - 2 cos(2 pi k f). Low frequencies, which rendered pictures have most of, weigh more.
class Fit {
 public:
  explicit Fit(double sigma) {
    for (std::size_t i = 0; i < kSteps; ++i) add((static_cast<double>(i) + 0.5) / (2 * kSteps), sigma);
  }

  // One weight after the other, until none changes.
  std::vector<double> weights() const {
    std::vector<double> weights(kBeside);
    for (int sweep = 0; sweep < 300; ++sweep) {
      for (std::size_t k = 0; k < kBeside; ++k) {
        double rest = lost_[k];
        for (std::size_t l = 0; l < kBeside; ++l) rest -= l == k ? 0 : products_[k][l] * weights[l];
        weights[k] = rest / products_[k][k];
      }
    }
    return weights;
  }

 private:
  void add(double frequency, double sigma) {
    const double weight = square(fixed::cos(kPi * frequency));
    const double lost = 1 - fixed::exp(-2 * square(kPi * sigma * frequency));
    std::array<double, kBeside> by{};
    for (std::size_t k = 0; k < kBeside; ++k)
      by[k] = 2 - 2 * fixed::cos(2 * kPi * static_cast<double>(k + 1) * frequency);
    for (std::size_t k = 0; k < kBeside; ++k) {
      lost_[k] += weight * by[k] * lost;
      for (std::size_t l = 0; l < kBeside; ++l) products_[k][l] += weight * by[k] * by[l];
    }
  }

  static constexpr std::size_t kSteps = 200;
  std::array<double, kBeside> lost_{};
  std::array<std::array<double, kBeside>, kBeside> products_{};
};

std::vector<double> sampled(double sigma) {
  std::vector<double> weights(static_cast<std::size_t>(std::ceil(kReach * sigma)));
  double sum = 1;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double far = static_cast<double>(k + 1) / sigma;
    weights[k] = fixed::exp(-0.5 * far * far);
    sum += 2 * weights[k];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

constexpr std::size_t kTogether = 4;  // pairs of neighbours at once; even, see below

// What a pair of neighbours adds to the middle: weight times how much they are brighter than it on average. All in 16
// bits, so that eight pixels go into the smallest vectors, and exactly nothing where all are equal. `up` and `down`
// round to the two sides; in turns they take back each other's error.
int up(Light middle, Light before, Light after, std::int16_t weight) {
  const auto mean = static_cast<Light>((before + after + 1) >> 1);
  return (static_cast<std::int16_t>(mean - middle) * weight) >> 16;
}
int down(Light middle, Light before, Light after, std::int16_t weight) {
  const auto mean = static_cast<Light>((before + after + 1) >> 1);
  return -((static_cast<std::int16_t>(middle - mean) * weight) >> 16);
}

// Neighbours of one row, from the nearest on.
struct Pairs {
  const Light* const* before;
  const Light* const* after;
  const std::int16_t* weights;
};

// Adds what `kPairs` pairs add to the middle to `out`: the middle itself where they are the first.
template <std::size_t kPairs, bool kFirst>
void add(const Light* middle, const Pairs& pairs, std::size_t count, Light* __restrict out) {
  constexpr std::size_t k1 = kPairs > 1 ? 1 : 0, k2 = kPairs > 2 ? 2 : 0, k3 = kPairs > 3 ? 3 : 0;
  const Light *a0 = pairs.before[0], *a1 = pairs.before[k1], *a2 = pairs.before[k2], *a3 = pairs.before[k3];
  const Light *b0 = pairs.after[0], *b1 = pairs.after[k1], *b2 = pairs.after[k2], *b3 = pairs.after[k3];
  const std::int16_t w0 = pairs.weights[0], w1 = pairs.weights[k1], w2 = pairs.weights[k2], w3 = pairs.weights[k3];
  for (std::size_t i = 0; i < count; ++i) {
    const Light at = middle[i];
    auto sum = static_cast<Light>((kFirst ? at : out[i]) + up(at, a0[i], b0[i], w0));
    if (kPairs > 1) sum = static_cast<Light>(sum + down(at, a1[i], b1[i], w1));
    if (kPairs > 2) sum = static_cast<Light>(sum + up(at, a2[i], b2[i], w2));
    if (kPairs > 3) sum = static_cast<Light>(sum + down(at, a3[i], b3[i], w3));
    out[i] = sum;
  }
}

template <bool kFirst>
void add(const Light* middle, const Pairs& pairs, std::size_t number, std::size_t count, Light* out) {
  if (number == 1) return add<1, kFirst>(middle, pairs, count, out);
  if (number == 2) return add<2, kFirst>(middle, pairs, count, out);
  if (number == 3) return add<3, kFirst>(middle, pairs, count, out);
  add<4, kFirst>(middle, pairs, count, out);
}

void keep_between(const Light* middle, const Light* before, const Light* after, std::size_t count,
                  Light* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) {
    const Light least = std::min(middle[i], std::min(before[i], after[i]));
    const Light most = std::max(middle[i], std::max(before[i], after[i]));
    out[i] = std::min(std::max(out[i], least), most);
  }
}

// `number` pairs, or none. Where the kernel sharpens, nothing leaves the range of a middle and its nearest neighbours.
void weigh(const Light* middle, const Pairs& pairs, std::size_t number, bool sharpens, std::size_t count, Light* out) {
  if (number == 0) std::copy_n(middle, count, out);
  for (std::size_t k = 0; k < number; k += kTogether) {
    const Pairs next{pairs.before + k, pairs.after + k, pairs.weights + k};
    const std::size_t together = std::min(kTogether, number - k);
    if (k == 0) add<true>(middle, next, together, count, out);
    if (k > 0) add<false>(middle, next, together, count, out);
  }
  if (sharpens) keep_between(middle, pairs.before[0], pairs.after[0], count, out);
}

// The same with longer vectors.
#if defined(__x86_64__)
__attribute__((target("avx2"), flatten)) void weigh_wide(const Light* middle, const Pairs& pairs, std::size_t number,
                                                         bool sharpens, std::size_t count, Light* out) {
  weigh(middle, pairs, number, sharpens, count, out);
}
#else
void weigh_wide(const Light*, const Pairs&, std::size_t, bool, std::size_t, Light*) {}
bool has_avx2() { return false; }
#endif

}  // namespace

// Rounded from the far end on, so that what rounding leaves goes to the next weight and not all to the middle.
std::vector<float> gaussian_kernel(double sigma) {
  const double width = std::min(sigma, kWidest);
  const std::vector<double> sides = width > kFitted ? sampled(width) : Fit(width).weights();
  std::vector<float> kernel(sides.size() + 1);
  double sum = 0, given = 0;
  for (std::size_t k = sides.size(); k > 0; --k) {
    sum += sides[k - 1];
    const double weight = rounded(sum - given);
    kernel[k] = static_cast<float>(weight);
    given += weight;
  }
  kernel[0] = static_cast<float>(1 - 2 * given);
  while (kernel.size() > 1 && kernel.back() == 0) kernel.pop_back();
  return kernel;
}

Smoother::Smoother(std::size_t height, std::size_t width, std::size_t planes, const std::vector<float>& kernel)
    : height_(height), width_(width), planes_(planes), reach_(kernel.size() - 1) {
  for (std::size_t k = 1; k <= reach_; ++k) {
    sharpens_ = sharpens_ || kernel[k] < 0;
    weights_.push_back(static_cast<std::int16_t>(std::min(std::lround(kernel[k] * 2 * 65536), 32767L)));
  }
  read_.resize(planes * apart());
  while (slots_ < 2 * reach_) slots_ = 2 * slots_ + 1;
  rows_.resize((slots_ + 1) * planes * width);
  written_.resize(planes * width);
  before_.resize(reach_);
  after_.resize(reach_);
}

void Smoother::run(FunctionRef<void(std::size_t, Light*)> read, FunctionRef<void(std::size_t, const Light*)> write) {
  for (std::size_t y = 0; y < height_ + reach_; ++y) {
    if (y < height_) {
      read(y, read_.data() + reach_);
      for (std::size_t plane = 0; plane < planes_; ++plane) blur_row(plane, row(y) + plane * width_);
    }
    if (y < reach_) continue;
    blur_column(y - reach_);
    write(y - reach_, written_.data());
  }
}

Light* Smoother::row(std::size_t y) { return rows_.data() + (y & slots_) * planes_ * width_; }

void Smoother::blur_row(std::size_t plane, Light* out) {
  Light* middle = read_.data() + plane * apart() + reach_;
  std::fill_n(middle - reach_, reach_, middle[0]);
  std::fill_n(middle + width_, reach_, middle[width_ - 1]);
  for (std::size_t k = 0; k < reach_; ++k) {
    before_[k] = middle - (k + 1);
    after_[k] = middle + (k + 1);
  }
  weigh(middle, width_, out);
}

void Smoother::blur_column(std::size_t y) {
  for (std::size_t k = 0; k < reach_; ++k) {
    before_[k] = row(y > k ? y - (k + 1) : 0);
    after_[k] = row(std::min(y + k + 1, height_ - 1));
  }
  weigh(row(y), planes_ * width_, written_.data());
}

void Smoother::weigh(const Light* middle, std::size_t count, Light* out) const {
  const Pairs pairs{before_.data(), after_.data(), weights_.data()};
  (has_avx2() ? weigh_wide : observation::weigh)(middle, pairs, reach_, sharpens_, count, out);
}

}  // namespace mimo::observation
