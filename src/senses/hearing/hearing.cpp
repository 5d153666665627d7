#include "senses/hearing/hearing.h"

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/fail.h"
#include "base/numbers.h"
#include "mimo/experimental/hearing.h"
#include "observation/sense.h"

namespace mimo::senses {
namespace {

using hearing::kBands;
using hearing::kEars;
using hearing::kWindow;
using observation::Field;
using observation::Signal;

constexpr double kUsualRadius = 0.0875;  // m: an adult's head, for what has no ball
constexpr const char* kEarNames[kEars] = {"ear_left", "ear_right"};

// What reaches the ears of one head.
class Reception : public observation::Process {
 public:
  Reception(int head, int ball, const HearingSetting& setting)
      : Process("hearing"),
        head_body_(head),
        ball_(ball),
        around_(*setting.around),
        ears_(around_.samples(), around_.rate(), std::max(kWindow, setting.ticks * around_.samples()),
              around_.sources(), setting.own),
        bands_(around_.rate(), setting.thresholds) {}

  const hearing::Ears& ears() const { return ears_; }
  // Of what was heard last. The two fields that tell of it are filled one after the other.
  hearing::Heard heard() const {
    if (ears_.silent(kWindow)) return {};
    std::array<std::array<float, kWindow>, kEars> samples;
    for (std::size_t ear = 0; ear < kEars; ++ear) ears_.latest(ear, samples[ear]);
    return bands_.hear(samples);
  }

 private:
  void rest(const mjModel&, const mjData&) override { ears_.rest(); }

  void go_on(const mjModel& model, const mjData& data) override {
    if (around_.blows().empty() && ears_.at_rest(around_.around(), around_.first_sample())) return ears_.pass();
    const hearing::Head head = head_now(model, data);
    for (const hearing::Blow& blow : around_.blows()) ears_.add(blow, head, around_.first_sample());
    ears_.advance(head, around_.around(), around_.first_sample());
  }

  hearing::Head head_now(const mjModel& model, const mjData& data) const {
    hearing::Head head;
    head.radius = ball_ < 0 ? kUsualRadius : model.geom_size[3 * ball_];
    head.middle = Eigen::Vector3d(ball_ < 0 ? data.xipos + 3 * head_body_ : data.geom_xpos + 3 * ball_);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(data.xmat + 9 * head_body_);
    const auto ears = hearing::ears_of_frame();
    for (std::size_t ear = 0; ear < kEars; ++ear) head.ears[ear] = frame * ears[ear];
    return head;
  }

  void save(ByteWriter& to) const override { ears_.save(to); }
  void load(ByteReader& from) override { ears_.load(from); }

  int head_body_, ball_;
  const Soundscape& around_;
  hearing::Ears ears_;
  hearing::Bands bands_;
};

class Hearing : public observation::Sense {
 public:
  Hearing(std::unique_ptr<Reception> reception, const HearingOptions& options, const HearingSetting& setting)
      : reception_(*reception), options_(options) {
    const Soundscape& around = *setting.around;
    for (const char* ear : kEarNames) {
      if (has_bit(options.wanted, MIMO_HEARING_EARS))
        fields_.push_back(wave(ear, setting.ticks * around.samples(), around.rate()));
    }
    if (has_bit(options.wanted, MIMO_HEARING_BANDS)) {
      fields_.push_back(bands());
      fields_.push_back(time_difference());
    }
    keep(std::move(reception));
  }

  observation::Share share() const override { return observation::Share::kHearing; }

  void write(const mjModel&, const mjData&, std::uint8_t* block) override {
    std::size_t field = 0;
    if (has_bit(options_.wanted, MIMO_HEARING_EARS)) {
      for (std::size_t ear = 0; ear < kEars; ++ear, ++field) {
        reception_.ears().latest(ear, Span<float>(at<float>(block, field), fields_[field].count()));
      }
    }
    if (!has_bit(options_.wanted, MIMO_HEARING_BANDS)) return;
    const hearing::Heard heard = reception_.heard();
    float* levels = at<float>(block, field);
    for (const auto& ear : heard.levels) levels = std::copy(ear.begin(), ear.end(), levels);
    *at<float>(block, field + 1) = heard.time_difference;
  }

 private:
  static Field wave(const char* ear, std::size_t count, double rate) {
    Field field;
    field.name = std::string("hearing/") + ear;
    field.shape = {count};
    field.unit = "Pa";
    field.sample_rate = rate;
    return field;
  }

  static Field bands() {
    Field field;
    field.name = "hearing/bands";
    field.shape = {kEars, kBands};
    field.unit = "dB";
    field.low = 0;
    const hearing::Levels centres = hearing::band_centres();
    for (const char* ear : kEarNames) {
      for (const double centre : centres) {
        field.labels.push_back(std::string(ear) + "/" + std::to_string(static_cast<int>(centre + 0.5)) + "Hz");
      }
    }
    return field;
  }

  static Field time_difference() {
    Field field;
    field.name = "hearing/time_difference";
    field.shape = {1};
    field.unit = "s";
    field.low = -1e-3;
    field.high = 1e-3;
    return field;
  }

  const Reception& reception_;
  HearingOptions options_;
};

int ball_of_head(const mjModel& model, int head) {
  int largest = -1;
  for (int geom = model.body_geomadr[head]; geom < model.body_geomadr[head] + model.body_geomnum[head]; ++geom) {
    const bool sphere = model.geom_type[geom] == mjGEOM_SPHERE;
    if (sphere && (largest < 0 || model.geom_size[3 * geom] > model.geom_size[3 * largest])) largest = geom;
  }
  return largest;
}

}  // namespace

std::unique_ptr<observation::Sense> make_hearing(const mjModel& model, const body::Body& body,
                                                 const HearingOptions& options, const HearingSetting& setting) {
  const int head = body.infant ? body.head : body.root;
  if (head <= 0) fail(Status::kUnsupported, "hearing: the agent has no head with ears; switch hearing off");
  const int ball = ball_of_head(model, head);
  return std::make_unique<Hearing>(std::make_unique<Reception>(head, ball, setting), options, setting);
}

Mouth mouth_of(const mjModel& model, const body::Body& body) {
  if (!body.infant || body.head <= 0)
    fail(Status::kUnsupported, "voice is 1, but only infants have a voice; expected 0");
  constexpr double kDown = 0.5;  // of the head's radius, below its middle: where the built-in faces have it
  const int ball = ball_of_head(model, body.head);
  const double radius = ball < 0 ? kUsualRadius : model.geom_size[3 * ball];
  const Eigen::Vector3d middle = ball < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(model.geom_pos + 3 * ball);
  Mouth mouth;
  mouth.head = body.head;
  mouth.axis = Eigen::Vector3d::UnitX();
  mouth.place = middle + radius * Eigen::Vector3d(std::sqrt(1 - kDown * kDown), 0, -kDown);
  return mouth;
}

}  // namespace mimo::senses
