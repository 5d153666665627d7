#include "engine/compile_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/status.h"

namespace mimo::engine {
namespace {

int compile_in_the_child() {
  alarm(30);
  try {
    const CompileLock lock;
    return 0;
  } catch (const Error& error) {
    return static_cast<int>(-static_cast<std::int32_t>(error.status()));
  }
}

int exit_status_of_a_child() {
  const pid_t child = fork();
  if (child == 0) _exit(compile_in_the_child());
  int status = -1;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(CompileLock, ForkWaitsUntilNobodyCompiles) {
  std::atomic<bool> compiling{false}, done{false};
  std::thread other([&] {
    const CompileLock lock;
    compiling = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    done = true;
  });
  while (!compiling) std::this_thread::yield();
  EXPECT_EQ(exit_status_of_a_child(), 0);
  EXPECT_TRUE(done);
  other.join();
  const CompileLock still_opens;
}

// As a signal handler may do that interrupts the compiler: nobody could wait for it.
TEST(CompileLock, AChildOfTheCompilingThreadIsRefused) {
  {
    const CompileLock lock;
    EXPECT_EQ(exit_status_of_a_child(), -static_cast<int>(Status::kForked));
  }
  EXPECT_EQ(exit_status_of_a_child(), 0);
}

}  // namespace
}  // namespace mimo::engine
