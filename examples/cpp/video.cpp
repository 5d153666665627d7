// An episode as a video: what the left eye sees, what the right eye sees, and the infant from outside, side by side.
// The infant moves at random, looks around, and changes its face every second. Frames go to ffmpeg through a pipe;
// where there is none they become PNG files.
//
//   c++ video.cpp $(pkg-config --cflags --libs mimo libpng) && ./a.out episode.mp4 10
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mimo/mimo.hpp>
#include <random>

namespace {

const std::size_t kSide = 256;  // of each of the three pictures, pixels
const std::size_t kWidth = 3 * kSide;
const int kRate = 25;  // frames a second

// Takes frames of kWidth x kSide RGB pixels.
class Film {
 public:
  virtual ~Film() {}
  virtual void add(const std::vector<std::uint8_t>& frame) = 0;
  virtual void finish() {}
};

// As one word for the shell, whatever is in it.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

class FfmpegFilm : public Film {
 public:
  explicit FfmpegFilm(const std::string& path) {
    const std::string command = "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgb24 -s " + std::to_string(kWidth) +
                                "x" + std::to_string(kSide) + " -r " + std::to_string(kRate) +
                                " -i - -pix_fmt yuv420p " + quoted(path);
    pipe_ = popen(command.c_str(), "w");
    if (pipe_ == nullptr) throw std::runtime_error("cannot start ffmpeg");
    std::signal(SIGPIPE, SIG_IGN);  // where ffmpeg stops, writing to it shall fail
  }
  ~FfmpegFilm() override {
    if (pipe_ != nullptr) pclose(pipe_);
  }
  void add(const std::vector<std::uint8_t>& frame) override {
    if (std::fwrite(frame.data(), 1, frame.size(), pipe_) != frame.size()) throw std::runtime_error("ffmpeg stopped");
  }
  void finish() override {
    const int result = pclose(pipe_);
    pipe_ = nullptr;
    if (result != 0) throw std::runtime_error("ffmpeg failed");
  }

 private:
  FILE* pipe_;
};

class PngFilm : public Film {
 public:
  explicit PngFilm(const std::string& path) : path_(path) {}
  void add(const std::vector<std::uint8_t>& frame) override {
    char number[16];
    std::snprintf(number, sizeof number, "_%05d.png", count_++);
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = kWidth;
    image.height = kSide;
    image.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_file(&image, (path_ + number).c_str(), 0, frame.data(), 0, nullptr)) {
      throw std::runtime_error(image.message);
    }
  }

 private:
  std::string path_;
  int count_ = 0;
};

std::unique_ptr<Film> open_film(const std::string& path) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") == 0) return std::unique_ptr<Film>(new FfmpegFilm(path));
  std::printf("no ffmpeg here: writing PNG files\n");
  return std::unique_ptr<Film>(new PngFilm(path));
}

mimo::Env make_world() {
  mimo_scene_config room = mimo::scene_config();
  room.name = "benchmark";
  mimo::Scene scene(room);
  mimo_agent_config infant = mimo::agent_config();
  infant.touch = 0;
  scene.add_agent(infant);
  mimo_camera_config outside = mimo::camera_config();
  outside.name = "outside";
  outside.placed = 1;
  outside.position[0] = 1.1;
  outside.position[1] = -0.7;
  outside.position[2] = 0.75;
  outside.look_at[2] = 0.35;
  scene.add_camera(outside);
  mimo_env_config config = mimo::env_config();
  config.samples = 4;  // smooth edges
  return mimo::Env(scene, config);
}

// Puts a picture of the observation into the frame, `place` pictures from the left.
void paste(const mimo::Block& block, const mimo_field& field, std::size_t place, std::vector<std::uint8_t>& frame) {
  const mimo::View<const std::uint8_t> rgb = block.view<std::uint8_t>(field);
  for (std::size_t row = 0; row < kSide; ++row) {
    const std::uint8_t* from = rgb.begin() + 3 * kSide * row;
    std::copy(from, from + 3 * kSide, frame.begin() + static_cast<std::ptrdiff_t>(3 * (kWidth * row + kSide * place)));
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string path = argc > 1 ? argv[1] : "episode.mp4";
  const int seconds = argc > 2 ? std::atoi(argv[2]) : 1;

  mimo::Env env = make_world();
  mimo::Block block = env.make_block();
  const mimo_field pictures[] = {env.layout().field("vision/eye_left"), env.layout().field("vision/eye_right"),
                                 env.layout().field("vision/outside")};
  std::vector<float> actions(env.layout().info().actions);
  std::vector<std::uint8_t> frame(3 * kWidth * kSide);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share(-0.2f, 0.2f);
  const std::unique_ptr<Film> film = open_film(path);

  env.reset(1, block);
  for (int number = 0; number < seconds * kRate; ++number) {
    for (float& action : actions) action = share(random);
    env.set_face(mimo_face_name(static_cast<std::size_t>(number / kRate) % 7));
    const double turn = 0.15 * number;
    env.look_at(1.0, 0.3 * std::sin(turn), 0.5, MIMO_LOOK_HEAD);              // from side to side
    for (int step = 0; step < 100 / kRate; ++step) env.step(actions, block);  // 100 steps a second
    for (std::size_t i = 0; i < 3; ++i) paste(block, pictures[i], i, frame);
    film->add(frame);
  }
  film->finish();
  std::printf("%d frames of %zu x %zu pixels\n", seconds * kRate, kWidth, kSide);
  return 0;
} catch (const mimo::Exception& error) {
  std::fprintf(stderr, "%s: %s\n", mimo_status_name(error.status()), error.what());
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
