#include <link.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "bench/measurements.h"
#include "programs/program.h"

namespace cli {
namespace {

// The MuJoCo that this process runs on. It is libmimo's: the program itself does not know it.
std::string loaded_mujoco() {
  std::string path;
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* found) {
        if (std::strstr(library->dlpi_name, "/libmujoco.") == nullptr) return 0;
        *static_cast<std::string*>(found) = library->dlpi_name;
        return 1;
      },
      &path);
  return path;
}

bool on_debians() {
  std::error_code error;
  return std::filesystem::equivalent(loaded_mujoco(), MIMO_DEBIAN_MUJOCO, error);
}

bool debians_installed() {
  std::error_code error;
  return std::filesystem::exists(MIMO_DEBIAN_MUJOCO, error);
}

bool receive_all(int file, void* to, std::size_t bytes) {
  for (auto* next = static_cast<char*>(to); bytes > 0;) {
    const ssize_t got = read(file, next, bytes);
    if (got <= 0) return false;
    next += got;
    bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

bool send_all(int file, const void* from, std::size_t bytes) {
  for (const auto* next = static_cast<const char*>(from); bytes > 0;) {
    const ssize_t sent = send(file, next, bytes, MSG_NOSIGNAL);
    if (sent <= 0) return false;
    next += sent;
    bytes -= static_cast<std::size_t>(sent);
  }
  return true;
}

// The world in which the original was measured.
WorldOptions reference_world(std::uint64_t seed) {
  WorldOptions world;
  world.scene = "benchmark";
  world.body = "mitten";
  world.actuation = "torque";
  world.seed = seed;
  return world;
}

}  // namespace

class ReferenceStep::InThisProcess {
 public:
  explicit InThisProcess(std::uint64_t seed)
      : world_(reference_world(seed), MIMO_JACOBIAN_DENSE, 0), actions_(world_.env(), seed) {}

  std::vector<double> run(std::size_t steps) {
    world_.forget();
    world_.run(draw(actions_, steps));
    return world_.times().seconds();
  }

 private:
  PhysicsWorld world_;
  RandomActions actions_;
};

// This program again, with Debian's MuJoCo in place of the other: both have the same interface. It is told how many
// steps to take and answers with the seconds of each.
class ReferenceStep::InChildProcess {
 public:
  explicit InChildProcess(std::uint64_t seed);
  ~InChildProcess();
  InChildProcess(const InChildProcess&) = delete;
  InChildProcess& operator=(const InChildProcess&) = delete;

  std::vector<double> run(std::size_t steps) {
    std::vector<double> seconds(steps);
    if (!send_all(file_, &steps, sizeof steps) || !receive_all(file_, seconds.data(), steps * sizeof(double))) {
      throw Failure("the process that measures reference steps has failed");
    }
    return seconds;
  }

 private:
  int file_ = -1;
  pid_t process_ = -1;
};

ReferenceStep::InChildProcess::InChildProcess(std::uint64_t seed) {
  std::string preload = "LD_PRELOAD=" MIMO_DEBIAN_MUJOCO, number = std::to_string(seed);
  std::vector<char*> environment = {preload.data()};
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (std::strncmp(*variable, "LD_PRELOAD=", 11) != 0) environment.push_back(*variable);
  }
  environment.push_back(nullptr);
  std::string name = "mimo-bench", serve = "--serve-reference", option = "--seed";
  char* arguments[] = {name.data(), serve.data(), option.data(), number.data(), nullptr};
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw Failure("no socket for the reference");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int result = posix_spawn(&process_, "/proc/self/exe", &actions, nullptr, arguments, environment.data());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  file_ = ends[0];
  if (result == 0) return;
  close(file_);
  throw Failure(std::string("no process for the reference: ") + std::strerror(result));
}

ReferenceStep::InChildProcess::~InChildProcess() {
  close(file_);
  waitpid(process_, nullptr, 0);
}

ReferenceStep::ReferenceStep(std::uint64_t seed, std::size_t room) : times_(room) {
  if (on_debians()) {
    here_ = std::make_unique<InThisProcess>(seed);
  } else if (debians_installed()) {
    child_ = std::make_unique<InChildProcess>(seed);
  }
}

ReferenceStep::~ReferenceStep() = default;

void ReferenceStep::run(std::size_t steps) {
  if (here_ == nullptr && child_ == nullptr) return;
  for (const double seconds : here_ ? here_->run(steps) : child_->run(steps)) times_.add(seconds);
}

void ReferenceStep::warm_up() {
  run(1);
  times_ = StepTimes(0);
}

void serve_reference(std::uint64_t seed) {
  if (!on_debians()) throw Failure("MuJoCo is " + loaded_mujoco() + ", not " MIMO_DEBIAN_MUJOCO);
  ReferenceStep reference(seed, 0);
  std::size_t steps = 0, done = 0;
  while (receive_all(STDIN_FILENO, &steps, sizeof steps)) {
    reference.run(steps);
    const auto& seconds = reference.times().seconds();
    if (!send_all(STDOUT_FILENO, seconds.data() + done, steps * sizeof(double))) return;
    done = seconds.size();
  }
}

}  // namespace cli
