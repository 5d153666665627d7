#include "engine/compile_lock.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "base/fail.h"
#include "base/fork.h"

namespace mimo::engine {
namespace {

constexpr std::chrono::seconds kPatience(10);  // of fork()
constexpr std::chrono::milliseconds kNap(1);

std::mutex mutex;
std::atomic<int> forks{0};       // that are waiting or under way
std::atomic<bool> stuck{false};  // MuJoCo's lock was closed when this process was forked
// Of this thread. It is the only one that lives on in a child.
thread_local bool compiling = false;
thread_local bool locked_for_fork = false;

void before_fork() {
  ++forks;
  const auto end = std::chrono::steady_clock::now() + kPatience;
  const auto worth_waiting = [end] { return !compiling && std::chrono::steady_clock::now() < end; };
  while (!(locked_for_fork = mutex.try_lock()) && worth_waiting()) std::this_thread::sleep_for(kNap);
}

void after_fork_in_parent() {
  if (locked_for_fork) mutex.unlock();
  locked_for_fork = false;
  --forks;
}

void after_fork_in_child() {
  if (!locked_for_fork) stuck = true;
  after_fork_in_parent();
  forks = 0;
}

[[maybe_unused]] const int watching = watch_forks(before_fork, after_fork_in_parent, after_fork_in_child);

}  // namespace

CompileLock::CompileLock() {
  if (stuck) {
    fail(Status::kForked,
         "this process was forked while another thread compiled a model, and MuJoCo's compiler is locked in it for "
         "ever; fork at another time, or spawn instead of forking");
  }
  while (forks > 0) std::this_thread::sleep_for(kNap);  // they have waited longer
  mutex.lock();
  compiling = true;
}

CompileLock::~CompileLock() {
  compiling = false;
  mutex.unlock();
}

}  // namespace mimo::engine
