#include "base/pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace mimo {
namespace {

// Counts how often each item ran, and notices two calls as the same thread at one time.
class Counter : public Job {
 public:
  Counter(std::size_t items, std::size_t threads) : counts(items), inside(threads) {}
  void run(std::size_t item, std::size_t thread) noexcept override {
    if (inside[thread].fetch_add(1) != 0) clash = true;
    counts[item].fetch_add(1);
    if (item % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    inside[thread].fetch_sub(1);
  }
  bool all_are(int expected) const {
    return std::all_of(counts.begin(), counts.end(), [=](const auto& count) { return count == expected; });
  }
  std::vector<std::atomic<int>> counts, inside;
  std::atomic<bool> clash{false};
};

TEST(Pool, DoesEveryItemOnceForAnyNumberOfThreads) {
  for (std::size_t threads : {1, 2, 3, 8}) {
    Pool pool(threads);
    for (std::size_t items : {0, 1, 2, 5, 100}) {
      Counter job(items, threads);
      for (int round = 1; round <= 20; ++round) {
        pool.run(job, items);
        ASSERT_TRUE(job.all_are(2 * round - 1));
        pool.start(job, items);
        pool.wait();
        ASSERT_TRUE(job.all_are(2 * round));
      }
      EXPECT_FALSE(job.clash);
    }
  }
}

// Every item waits until the caller has come back from start().
class Waiter : public Job {
 public:
  void run(std::size_t, std::size_t) noexcept override {
    while (!returned) std::this_thread::yield();
  }
  std::atomic<bool> returned{false};
};

TEST(Pool, WorksWhileTheCallerDoesSomethingElse) {
  for (std::size_t threads : {1, 3}) {
    Pool pool(threads);
    Waiter job;
    pool.start(job, 5);
    job.returned = true;
    pool.wait();
  }
}

// The first item that a thread takes is not done before all other items are.
class OneWaitsForTheOthers : public Job {
 public:
  explicit OneWaitsForTheOthers(int items) : missing(items) {}
  void run(std::size_t item, std::size_t) noexcept override {
    if (item != 0) {
      --missing;
      return;
    }
    const auto start = std::chrono::steady_clock::now();
    while (missing > 1 && std::chrono::steady_clock::now() - start < std::chrono::seconds(20))
      std::this_thread::yield();
    waited_for_all = missing == 1;
  }
  std::atomic<int> missing;
  bool waited_for_all = false;
};

TEST(Pool, OthersDoTheShareOfAThreadThatIsHeldUp) {
  for (std::size_t threads : {2, 5}) {
    OneWaitsForTheOthers now(20), later(20);
    Pool pool(threads);
    pool.run(now, 20);
    EXPECT_TRUE(now.waited_for_all);
    pool.start(later, 20);
    pool.wait();
    EXPECT_TRUE(later.waited_for_all);
  }
}

TEST(Pool, OfOneThreadIsTheCaller) {
  struct : Job {
    void run(std::size_t, std::size_t) noexcept override { mine = std::this_thread::get_id() == caller; }
    std::thread::id caller = std::this_thread::get_id();
    bool mine = false;
  } job;
  Pool(1).run(job, 1);
  EXPECT_TRUE(job.mine);
}

}  // namespace
}  // namespace mimo
