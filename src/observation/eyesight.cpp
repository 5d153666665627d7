#include "observation/eyesight.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "observation/blur.h"

namespace mimo::observation {
namespace {

// Of the Gaussian that leaves 1 / `contrast` of lines of so many cycles per degree.
double sigma_of(double cycles, double contrast) {
  return cycles > 0 ? std::sqrt(fixed::log(contrast) / 2) / (kPi * cycles) : 0;
}

// One Gaussian for all colours; that for differences of colours would have to be about twice as wide. Of two, one after
// the other, it is one as well.
std::vector<float> kernel_of(const Eyesight& eyes, double pixels_per_degree) {
  return gaussian_kernel(length_of(eyes.sigma(), sigma_of(eyes.blur, 2)) * pixels_per_degree);
}

double left_of(const std::vector<float>& kernel, double cycles_per_pixel) {
  double left = kernel[0];
  for (std::size_t k = 1; k < kernel.size(); ++k) {
    left += 2 * static_cast<double>(kernel[k]) * fixed::cos(2 * kPi * static_cast<double>(k) * cycles_per_pixel);
  }
  return left;
}

// The sensitivity is that of the whole eye. Here its optics have already weakened what it sees, and so the least
// contrast of what they leave is as much smaller.
Bands bands_of(std::size_t height, std::size_t width, double pixels_per_degree, const Eyesight& eyes) {
  if (!eyes.threshold || eyes.acuity <= 0) return {};
  const std::vector<float> kernel = gaussian_kernel(eyes.sigma() * pixels_per_degree);
  std::vector<double> least;
  for (std::size_t band = 0; band < Bands::number(height, width); ++band) {
    const double cycles = Bands::middle(band);
    least.push_back(left_of(kernel, cycles) / sensitivity(eyes, cycles * pixels_per_degree));
  }
  return {height, width, least};
}

// Rounded; lround would be called for each pixel.
Light as_light(float value) {
  const float up = value + 0.5F;
  return static_cast<Light>(up);
}

float luminance_at(const Light* row, std::size_t planes, std::size_t width, std::size_t x) {
  const auto light = [&](std::size_t plane) { return static_cast<float>(row[plane * width + x]) - kBlack; };
  return planes == 1 ? light(0) : 0.2126F * light(0) + 0.7152F * light(1) + 0.0722F * light(2);
}

void luminances(const Light* row, std::size_t planes, std::size_t width, float* luminance) {
  for (std::size_t x = 0; x < width; ++x) luminance[x] = luminance_at(row, planes, width, x);
}

// All colours get as much more light as the luminance does.
void set_luminances(const float* luminance, std::size_t planes, std::size_t width, Light* row) {
  for (std::size_t x = 0; x < width; ++x) {
    const float more = luminance[x] - luminance_at(row, planes, width, x);
    for (std::size_t plane = 0; plane < planes; ++plane) {
      Light& light = row[plane * width + x];
      light = as_light(std::clamp<float>(static_cast<float>(light) + more, kBlack, kWhite));
    }
  }
}

}  // namespace

double Eyesight::sigma() const { return sigma_of(acuity, peak_contrast); }

double sensitivity(const Eyesight& eyes, double cycles) {
  const double height = fixed::log10(eyes.peak_contrast);
  const double from_peak = fixed::log10(cycles / eyes.acuity) + std::sqrt(height) / 1.28;
  return fixed::pow(10, height - square((from_peak < 0 ? 0.68 : 1.28) * from_peak));
}

EyeFilter::EyeFilter(std::size_t height, std::size_t width, double pixels_per_degree, const Eyesight& eyes)
    : height_(height),
      width_(width),
      planes_(eyes.chroma > 0 ? 3 : 1),
      eyes_(eyes),
      smoother_(height, width, planes_, kernel_of(eyes, pixels_per_degree)),
      bands_(bands_of(height, width, pixels_per_degree, eyes)) {
  if (bands_.any()) {
    picture_.resize(height * planes_ * width);
    luminance_.resize(height * width);
  }
  if (!remembers()) return;
  memory_.resize(height * planes_ * width, kBlack);
  row_.resize(planes_ * width);
}

// A cut-off f belongs to a time constant of 1 / (2 pi f). Rounded, so that the last bit of a library's exp is lost.
void EyeFilter::advance(double seconds) {
  const double share = 1 - fixed::exp(-seconds * 2 * kPi * eyes_.flicker);
  share_ = static_cast<float>(std::round(share * 65536) / 65536);
}

void EyeFilter::filter(std::uint8_t* rgb) {
  if (!eyes_.any()) return;
  smoother_.run([&](std::size_t y, Light* row) { read(rgb + y * width_ * 3, row); },
                [&](std::size_t y, const Light* row) { take(y, row, rgb); });
  if (bands_.any()) {
    clear_unseen();
    for (std::size_t y = 0; y < height_; ++y) write(y, picture_.data() + y * planes_ * width_, rgb);
  }
  begun_ = begun_ || !glances_;
}

void EyeFilter::glance(std::uint8_t* rgb) {
  glances_ = true;
  filter(rgb);
  glances_ = false;
}

// Blurring and fading may come in any order; pictures without colour are a third of the work.
void EyeFilter::read(const std::uint8_t* rgb, Light* row) const {
  if (planes_ == 1) return kLightTables.decode_grey(rgb, width_, row);
  Light *green = row + smoother_.apart(), *blue = green + smoother_.apart();
  kLightTables.decode(rgb, width_, row, green, blue);
  if (eyes_.chroma < 1) fade(row, green, blue, width_, 1 - eyes_.chroma);
}

void EyeFilter::take(std::size_t y, const Light* row, std::uint8_t* rgb) {
  if (!bands_.any()) return write(y, row, rgb);
  std::copy_n(row, planes_ * width_, picture_.data() + y * planes_ * width_);
}

// Of the luminance: differences of colours stay as they are.
void EyeFilter::clear_unseen() {
  const std::size_t row = planes_ * width_;
  for (std::size_t y = 0; y < height_; ++y) {
    luminances(picture_.data() + y * row, planes_, width_, luminance_.data() + y * width_);
  }
  bands_.clear_unseen(luminance_.data());
  for (std::size_t y = 0; y < height_; ++y) {
    set_luminances(luminance_.data() + y * width_, planes_, width_, picture_.data() + y * row);
  }
}

void EyeFilter::write(std::size_t y, const Light* row, std::uint8_t* rgb) {
  const Light* seen = remembers() ? remember(y, row) : row;
  std::uint8_t* out = rgb + y * width_ * 3;
  if (planes_ == 1) return kLightTables.encode_grey(seen, width_, out);
  kLightTables.encode(seen, seen + width_, seen + 2 * width_, width_, out);
}

const Light* EyeFilter::remember(std::size_t y, const Light* row) {
  const std::size_t count = planes_ * width_;
  float* memory = memory_.data() + y * count;
  if (!begun_ && glances_) return row;
  if (!begun_) std::copy_n(row, count, memory);
  for (std::size_t i = 0; i < count; ++i) {
    const float light = memory[i] + share_ * (static_cast<float>(row[i]) - memory[i]);
    if (!glances_) memory[i] = light;
    row_[i] = as_light(light);
  }
  return row_.data();
}

void EyeFilter::save(ByteWriter& to) const {
  to.put(begun_);
  to.put(Span<const float>(memory_));
}

void EyeFilter::load(ByteReader& from) {
  const bool begun = from.take_flag();
  begin();
  from.take(Span<float>(memory_));
  for (const float light : memory_) {
    require(light >= 0 && light <= 65535, "the state holds {} for light, expected 0 to 65535", light);
  }
  begun_ = begun;
}

}  // namespace mimo::observation
