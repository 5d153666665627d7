// The guard around MuJoCo's errors and warnings, and what the host had set for them.
#include "engine/guard.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "compat/mujoco.h"
#include "support/quiet.h"
#include "support/tiny.h"

// MuJoCo writes the text of its first warning into one buffer for all threads, even when nobody reads it.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() { return "race:mju_warningText\n"; }

extern "C" {
#if MIMO_MUJOCO_4
mjfLogHandler _mjPRIVATE_setTlsLogHandler(mjfLogHandler);
#else
void (*_mjPRIVATE__get_tls_error_fn())(const char*);
void (*_mjPRIVATE__get_tls_warning_fn())(const char*);
void _mjPRIVATE__set_tls_error_fn(void (*)(const char*));
void _mjPRIVATE__set_tls_warning_fn(void (*)(const char*));
#endif
}

namespace mimo::test {
namespace {

using engine::Complaint;
using engine::guarded;
using EngineGuard = QuietTest;

// What a thread's errors and warnings are given to, beside what all threads' are; MuJoCo 4 gives both to one.
struct ThreadHandlers {
#if MIMO_MUJOCO_4
  mjfLogHandler of_messages = nullptr;
  static ThreadHandlers now() {
    const ThreadHandlers found{_mjPRIVATE_setTlsLogHandler(nullptr)};
    found.set();
    return found;
  }
  void set() const { _mjPRIVATE_setTlsLogHandler(of_messages); }
  bool operator==(const ThreadHandlers& other) const { return of_messages == other.of_messages; }
#else
  void (*of_errors)(const char*) = nullptr;
  void (*of_warnings)(const char*) = nullptr;
  static ThreadHandlers now() { return {_mjPRIVATE__get_tls_error_fn(), _mjPRIVATE__get_tls_warning_fn()}; }
  void set() const {
    _mjPRIVATE__set_tls_error_fn(of_errors);
    _mjPRIVATE__set_tls_warning_fn(of_warnings);
  }
  bool operator==(const ThreadHandlers& other) const {
    return of_errors == other.of_errors && of_warnings == other.of_warnings;
  }
#endif
};

TEST_F(EngineGuard, ErrorIsCaught) {
  bool went_on = false;
  const Complaint complaint = guarded([&] {
    mju_error("no way");
    went_on = true;
  });
  EXPECT_TRUE(complaint.failed);
  EXPECT_STREQ(complaint.error.data(), "no way");
  EXPECT_EQ(complaint.warnings, 0);
  EXPECT_FALSE(went_on);
}

TEST_F(EngineGuard, WarningsAreCountedAndTheFirstIsKept) {
  const Complaint complaint = guarded([] {
    mju_warning("first");
    mju_warning("second");
  });
  EXPECT_FALSE(complaint.failed);
  EXPECT_EQ(complaint.warnings, 2);
  EXPECT_STREQ(complaint.warning.data(), "first");
  EXPECT_STREQ(complaint.error.data(), "");
}

TEST_F(EngineGuard, LongTextIsCut) {
  const std::string text(900, 'x');
  const Complaint complaint = guarded([&] { mju_error(text.c_str()); });
  EXPECT_EQ(std::strlen(complaint.error.data()), complaint.error.size() - 1);
}

TEST_F(EngineGuard, Nested) {
  Complaint inner;
  const Complaint outer = guarded([&] {
    inner = guarded([] { mju_error("inner"); });
    mju_warning("between");
    mju_error("outer");
  });
  EXPECT_TRUE(inner.failed);
  EXPECT_STREQ(inner.error.data(), "inner");
  EXPECT_TRUE(outer.failed);
  EXPECT_STREQ(outer.error.data(), "outer");
  EXPECT_STREQ(outer.warning.data(), "between");
  EXPECT_EQ(inner.warnings, 0);
}

TEST_F(EngineGuard, ExceptionsPassAndTheGuardStillWorks) {
  EXPECT_THROW(guarded([] { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_TRUE(ThreadHandlers::now() == ThreadHandlers());
  EXPECT_STREQ(guarded([] { mju_error("later"); }).error.data(), "later");
}

// What the host has set: it must be back after every call, and must not hear of what happens in ours.
int host_errors = 0, host_warnings = 0;
void host_error(const char*) {
  ++host_errors;
  throw std::runtime_error("host");
}
void host_warning(const char*) { ++host_warnings; }

#if MIMO_MUJOCO_4
void host_message(const mjLogMessage* message) {
  message->level == mjLOG_ERROR ? host_error(message->subject) : host_warning(message->subject);
}
ThreadHandlers hosts() { return {host_message}; }
#else
ThreadHandlers hosts() { return {host_error, host_warning}; }
#endif

class HostHandlers : public EngineGuard {
 protected:
  void SetUp() override { host_errors = host_warnings = 0; }

  // Everything that the engine does with MuJoCo, succeeding and failing.
  static void use_the_engine() {
    engine::Physics physics(compiled(pile(16, "<size nconmax='5'/>")), {});
    physics.step(100);
    physics.data().qpos[0] = 1e300;
    expect_error(Status::kSimulation, "QPOS", [&] { physics.step(1); });
    expect_error(Status::kModel, "", [] { compiled("<mujoco><nonsense/></mujoco>"); });
    EXPECT_TRUE(guarded([] { mju_error("ours"); }).failed);
    EXPECT_THROW(guarded([] { throw std::bad_alloc(); }), std::bad_alloc);
  }
};

TEST_F(HostHandlers, GlobalOnesAreBack) {
  mju_user_error = host_error;
  mju_user_warning = host_warning;
  use_the_engine();
  EXPECT_EQ(mju_user_error, host_error);
  EXPECT_EQ(mju_user_warning, host_warning);
  EXPECT_EQ(host_errors + host_warnings, 0);
  mju_warning("the host's own");
  EXPECT_EQ(host_warnings, 1);
  mju_user_error = nullptr;
  mju_user_warning = nullptr;
}

TEST_F(HostHandlers, ThreadLocalOnesAreBack) {
  hosts().set();
  use_the_engine();
  EXPECT_TRUE(ThreadHandlers::now() == hosts());
  EXPECT_EQ(host_errors + host_warnings, 0);
  mju_warning("the host's own");
  EXPECT_EQ(host_warnings, 1);
  ThreadHandlers().set();
}

// Worlds that fail and worlds that do not, on eight threads at once. For the thread sanitizer, and for the numbers.
TEST_F(EngineGuard, EightThreads) {
  constexpr int kThreads = 8, kRounds = 10;
  const engine::ModelPtr model = compiled(pile(4, ""));
  engine::Physics reference(model, {});
  const std::vector<double> expected = trajectory(reference, 50);
  std::vector<int> good(kThreads), caught(kThreads);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (int round = 0; round < kRounds; ++round) {
        engine::Physics failing(model, {});
        engine::Physics fine(model, {});
        failing.data().qvel[0] = 1e300;
        const std::string text = "thread " + std::to_string(t);
        const Complaint complaint = guarded([&] { mju_error(text.c_str()); });
        bool refused = false, failed = false;
        try {
          compiled("<mujoco><nonsense/></mujoco>");
        } catch (const Error& error) {
          refused = error.status() == Status::kModel;
        }
        try {
          failing.step(1);
        } catch (const Error& error) {
          failed = error.status() == Status::kSimulation;
        }
        caught[t] += refused && failed && text == complaint.error.data();
        failing.reset();
        good[t] += trajectory(fine, 50) == expected && trajectory(failing, 50) == expected;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(caught, std::vector<int>(kThreads, kRounds));
  EXPECT_EQ(good, std::vector<int>(kThreads, kRounds));
}

}  // namespace
}  // namespace mimo::test
