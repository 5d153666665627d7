// A few threads that share a job: worlds of a batch, or rows of a picture.
//
// All that is needed is one job at a time, "call this for each of n items", handed over without an allocation. Why no
// library does it: docs/adr/0008-thread-pool.md.
#pragma once

#include <pthread.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace mimo {

// A thread of the library in the host's process.

// Signals that are sent to the process are the host's business: this thread takes none, from its first moment on. Its
// stack is large enough for us, also where the host's threads have small ones.
class Thread {
 public:
  using Run = void* (*)(void* argument);

  // Throws Status::kOutOfMemory when the system has no thread to give, Status::kUnsupported where the library is built
  // without threads.
  Thread(Run run, void* argument);
  ~Thread() { pthread_join(thread_, nullptr); }
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

 private:
  pthread_t thread_;
};

// What is to be done for every item. It must not throw. `thread` is a number below Pool::threads(); no two calls with
// the same number run at the same time.
class Job {
 public:
  virtual void run(std::size_t item, std::size_t thread) noexcept = 0;

 protected:
  ~Job() = default;
};

class Pool {
 public:
  explicit Pool(std::size_t threads);  // at least 1
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  std::size_t threads() const { return threads_; }

  // Runs the job for items 0 to count - 1 and returns when all are done. The calling thread is one of the threads, so
  // that a pool of one does without any hand-over.
  void run(Job& job, std::size_t count);

  // The same in two parts: start() returns at once and leaves the work to the pool, wait() returns when all is done.
  void start(Job& job, std::size_t count);
  void wait();

 private:
  struct Worker {
    Worker(Pool& its_pool, std::size_t its_number) : pool(its_pool), number(its_number) {}

    Pool& pool;
    const std::size_t number;
    std::condition_variable wake;
    std::atomic<bool> invited{false};
    std::optional<Thread> thread;
  };

  // Items that a thread takes before all others: mostly the same in each job, so that its core has in the cache what
  // they need. Who has no more takes those of others, one at a time.
  struct alignas(64) Share {
    std::atomic<std::size_t> next{0};
    std::size_t end = 0;

    bool empty() const { return next.load(std::memory_order_relaxed) >= end; }
    // Whether there was one.
    bool take(std::size_t& item) { return !empty() && (item = next.fetch_add(1, std::memory_order_relaxed)) < end; }
  };

  void add_worker();
  void stop() noexcept;
  void open(Job& job, std::size_t count, std::size_t helpers);
  void close();
  bool done() const;
  void work(std::size_t thread);
  void live(Worker& worker);

  const std::size_t threads_;
  std::mutex mutex_;
  std::condition_variable idle_;
  std::vector<std::unique_ptr<Worker>> workers_;  // threads - 1; one more once start() was called
  std::atomic<bool> stopping_{false};
  std::atomic<std::size_t> inside_{0};  // workers that are working
  Job* job_ = nullptr;
  std::vector<Share> shares_;  // by threads
};

}  // namespace mimo
