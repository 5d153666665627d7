// An event camera out of each eye's pictures: a pixel tells that its log intensity has risen or fallen by a threshold,
// and is silent for a refractory time. A sense in one file, for mimo::Scene::load_sense or Scene.load_sense in Python.
//
// After Lichtsteiner, Posch and Delbruck 2008 (IEEE J Solid-State Circuits 43:566) and Rebecq et al. 2018 (ESIM). A
// picture is drawn `rate` times a second, also where nobody looks: that is what it costs.
#include <cmath>
#include <mimo/mimo.hpp>

namespace {

struct Pixel {
  float reference;   // log intensity at the last event
  float rise, fall;  // events since the last environment step began
  float silent;      // s for which it stays so
};

enum Parameter { kThreshold, kRefractory, kRate, kCount };

class Events : public mimo::Sense {
 public:
  static std::vector<mimo_parameter> parameters() {
    using mimo::sense_parameter;
    std::vector<mimo_parameter> all(kCount);
    all[kThreshold] = sense_parameter("threshold", "change of the natural logarithm of intensity", 0.2, 0.01, 5);
    all[kRefractory] = sense_parameter("refractory", "time between two events of a pixel, s", 0.001, 0, 1);
    all[kRate] = sense_parameter("rate", "pictures a second, at most one for each physics step", 100, 1, 1000);
    return all;
  }

  // Fields: events/eye_left and events/eye_right, height x width x 2, how often intensity rose and fell in the step.
  explicit Events(mimo::SenseOpening& opening) {
    const double ticks = 1 / (opening.told.parameters[kRate] * opening.told.timestep);
    every_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(ticks)));
    for (const char* eye : {"eye_left", "eye_right"}) {
      const std::string name = opening.own(std::string("vision/") + eye);
      const mimo_field picture = opening.world.layout().field(name);
      mimo::SenseField field(eye, {picture.shape[0], picture.shape[1], 2}, "", "camera");
      field.low = 0;
      opening.add(field);
      pictures_.push_back(opening.world.layout().find(name));
      pixels_ = picture.shape[0] * picture.shape[1];
    }
    opening.memory_bytes = pictures_.size() * pixels_ * sizeof(Pixel);
  }

  void reset(const mimo::SenseMoment& now) const override {
    for_each(now, [](Pixel& pixel, double log_intensity) { pixel.reference = static_cast<float>(log_intensity); });
  }

  void advance(const mimo::SenseMoment& now) const override {
    const double threshold = now.told.parameters[kThreshold], refractory = now.told.parameters[kRefractory];
    const double frame = static_cast<double>(every_) * now.told.timestep;
    if ((now.told.tick - 1) % now.told.step_ticks == 0) {
      Pixel* all = &now.memory<Pixel>();
      for (std::size_t i = 0; i < pictures_.size() * pixels_; ++i) all[i].rise = all[i].fall = 0;
    }
    if (now.told.tick % every_ != 0) return;
    for_each(now, [=](Pixel& pixel, double log_intensity) {
      const double change = log_intensity - pixel.reference;
      const double crossed = std::floor(std::abs(change) / threshold);
      const double free = frame - pixel.silent;  // of this frame's time
      pixel.silent = static_cast<float>(std::max(0.0, -free));
      if (crossed < 1 || free <= 0) return;
      const double most = refractory > 0 ? std::max(1.0, std::floor(free / refractory)) : crossed;
      const double events = std::min(crossed, most);
      pixel.silent = static_cast<float>(std::max(0.0, events * refractory - free));
      pixel.reference += static_cast<float>((change > 0 ? 1 : -1) * crossed * threshold);
      (change > 0 ? pixel.rise : pixel.fall) += static_cast<float>(events);
    });
  }

  void write(const mimo::SenseMoment& now) const override {
    const Pixel* pixel = &now.memory<Pixel>();
    for (std::size_t eye = 0; eye < pictures_.size(); ++eye) {
      float* to = now.field(eye);
      for (std::size_t i = 0; i < pixels_; ++i, ++pixel) {
        to[2 * i] = pixel->rise;
        to[2 * i + 1] = pixel->fall;
      }
    }
  }

 private:
  // Each pixel and the logarithm of its intensity now: of the colour's luma, with one level of 255 as dark current.
  template <typename Visit>
  void for_each(const mimo::SenseMoment& now, Visit&& visit) const {
    Pixel* pixel = &now.memory<Pixel>();
    for (const std::size_t picture : pictures_) {
      const std::uint8_t* rgb = now.feel<std::uint8_t>(picture);
      for (std::size_t i = 0; i < pixels_; ++i, rgb += 3) {
        visit(*pixel++, std::log(1 + 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]));
      }
    }
  }

  std::vector<std::size_t> pictures_;  // fields
  std::size_t pixels_ = 0;             // of one
  std::size_t every_;                  // physics steps of a picture
};

}  // namespace

MIMO_SENSE(mimo::sense<Events>("events"))
