// A world on a thread of its own, in real time, and a program that draws at another rate: it shows the infant where it
// was one step ago, between its last two poses. Unity's frame stands for that of any engine.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <mimo/mimo.hpp>
#include <mutex>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// Of one body: position, and a quaternion x y z w.
using Pose = std::array<float, 7>;

struct Poses {
  double time = 0;  // s, of the world
  std::vector<Pose> of_bodies;
};

// The last two poses, which both threads use in turn.
class Shared {
 public:
  explicit Shared(const Poses& first) : before_(first), last_(first) {}

  void push(const Poses& poses) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(before_, last_);
    last_ = poses;
  }
  std::pair<Poses, Poses> both() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {before_, last_};
  }

 private:
  std::mutex mutex_;
  Poses before_, last_;
};

Poses read(mimo::Env& env, const std::vector<std::int32_t>& bodies) {
  std::vector<float> numbers = env.get_floats(MIMO_BODY_POSE | MIMO_NOW, bodies);
  mimo::convert_poses(MIMO_AXES_UNITY, numbers);
  Poses poses{env.time(), std::vector<Pose>(bodies.size())};
  for (std::size_t i = 0; i < numbers.size(); ++i) poses.of_bodies[i / 7][i % 7] = numbers[i];
  return poses;
}

// Between two poses. A quaternion and its negative are the same rotation, so the nearer of both is taken.
Pose between(const Pose& from, const Pose& to, float share) {
  float along = 0, square = 0;
  for (int i = 3; i < 7; ++i) along += from[i] * to[i];
  Pose pose{};
  for (int i = 0; i < 7; ++i) {
    const float end = i >= 3 && along < 0 ? -to[i] : to[i];
    pose[i] = from[i] + share * (end - from[i]);
    if (i >= 3) square += pose[i] * pose[i];
  }
  for (int i = 3; i < 7; ++i) pose[i] /= std::sqrt(square);
  return pose;
}

}  // namespace

int main() try {
  mimo_scene_config room = mimo::scene_config();
  room.name = "free";
  mimo::Scene scene(room);
  mimo_agent_config infant = scene.default_agent();
  infant.vision = 0;
  scene.add_agent(infant);
  mimo::Env env(scene);
  mimo::Block senses = env.layout().make_block();
  env.reset(7, senses);
  const std::vector<std::int32_t> bodies = {env.find(MIMO_BODY, "head"), env.find(MIMO_BODY, "left_hand")};
  const double step = env.layout().info().step_seconds;
  Shared shared(read(env, bodies));
  std::atomic<bool> over{false};

  // From here on only this thread uses the world. An exception must not leave a thread: it goes to the one that draws.
  std::exception_ptr failure;
  std::thread simulation([&] {
    try {
      const Clock::time_point start = Clock::now();
      std::vector<float> action(env.layout().info().actions);
      for (int i = 1; !over; ++i) {
        for (float& share : action) share = 0.3F * static_cast<float>(std::sin(6.0 * env.time()));
        env.step(action, senses);
        shared.push(read(env, bodies));
        std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(Seconds(i * step)));
      }
    } catch (...) {
      failure = std::current_exception();
      over = true;
    }
  });

  const Clock::time_point start = Clock::now();
  for (int frame = 1; frame <= 60 && !over; ++frame) {
    std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(Seconds(frame / 60.0)));
    const auto [before, last] = shared.both();
    const double shown = Seconds(Clock::now() - start).count() - step;
    const double length = last.time - before.time;
    const double share = length > 0 ? std::fmin(1, std::fmax(0, (shown - before.time) / length)) : 1;
    const Pose hand = between(before.of_bodies[1], last.of_bodies[1], static_cast<float>(share));
    if (frame % 20 == 0) std::printf("%.2f s: the left hand at %.3f, %.3f, %.3f m\n", shown, hand[0], hand[1], hand[2]);
  }
  over = true;
  simulation.join();
  if (failure) std::rethrow_exception(failure);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
