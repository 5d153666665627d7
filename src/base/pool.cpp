#include "base/pool.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <thread>

#include "base/fail.h"
#include "base/process.h"

namespace mimo {
namespace {

constexpr std::size_t kLeastStack = 512 * 1024;

// Without threads, Emscripten's pthread_create reports that the system has none left.
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
constexpr bool kHasThreads = false;
#else
constexpr bool kHasThreads = true;
#endif

// The default is the limit of the shell that the host was started from, which may be anything.
class Attributes {
 public:
  Attributes() {
    std::size_t stack = 0;
    pthread_attr_init(&attributes_);
    pthread_attr_getstacksize(&attributes_, &stack);
    pthread_attr_setstacksize(&attributes_, std::max(stack, kLeastStack));
  }
  ~Attributes() { pthread_attr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const pthread_attr_t* get() const { return &attributes_; }

 private:
  pthread_attr_t attributes_;
};

// Waits a little without sleeping: to wake a thread takes as long as a tenth of a step of a world, and the next step
// mostly follows at once. Other threads that want the processor get it.
template <typename Ready>
void stay_awake(Ready&& ready) {
  constexpr std::chrono::microseconds kPatience(100);
  const auto start = std::chrono::steady_clock::now();
  while (!ready() && std::chrono::steady_clock::now() - start < kPatience) std::this_thread::yield();
}

}  // namespace

Thread::Thread(Run run, void* argument) {
  if (!kHasThreads) fail(Status::kUnsupported, "this build of the library has no threads besides the caller's");
  const Attributes attributes;
  const SignalsBlocked signals;  // a new thread inherits the mask of the one that starts it
  const int error = pthread_create(&thread_, attributes.get(), run, argument);
  if (error == 0) return;
  fail(Status::kOutOfMemory, "the system cannot start a thread: {}", std::generic_category().message(error));
}

Pool::Pool(std::size_t threads) : threads_(threads), shares_(threads) {
  workers_.reserve(threads);
  try {
    while (workers_.size() + 1 < threads) add_worker();
  } catch (...) {
    stop();
    throw;
  }
}

Pool::~Pool() { stop(); }

void Pool::run(Job& job, std::size_t count) {
  open(job, count, std::min(workers_.size(), threads_ - 1));
  work(threads_ - 1);
  close();
}

void Pool::start(Job& job, std::size_t count) {
  if (workers_.size() < threads_) add_worker();
  open(job, count, threads_);
}

void Pool::wait() { close(); }

void Pool::add_worker() {
  const std::size_t number = workers_.size();
  workers_.push_back(std::make_unique<Worker>(*this, number));
  const auto live = [](void* worker) -> void* {
    static_cast<Worker*>(worker)->pool.live(*static_cast<Worker*>(worker));
    return nullptr;
  };
  try {
    workers_.back()->thread.emplace(live, workers_.back().get());
  } catch (const Error& error) {
    workers_.pop_back();
    const std::string_view advice = kHasThreads ? ", ask for fewer" : "";
    fail(error.status(), "thread {} of {} cannot be started{}: {}", number + 1, threads_, advice, error.message());
  }
}

// Wakes as many workers as have something to do.
void Pool::open(Job& job, std::size_t count, std::size_t helpers) {
  {
    const std::lock_guard lock(mutex_);
    job_ = &job;
    for (std::size_t i = 0; i < threads_; ++i) {
      shares_[i].next.store(i * count / threads_, std::memory_order_relaxed);
      shares_[i].end = (i + 1) * count / threads_;
    }
    helpers = std::min(helpers, count);
    for (std::size_t i = 0; i < helpers; ++i) workers_[i]->invited = true;
  }
  for (std::size_t i = 0; i < helpers; ++i) workers_[i]->wake.notify_one();
}

// Waits for the threads that joined. A late thread finds no job: on a busy machine nothing waits for a thread only
// to learn that there is nothing left for it to do.
void Pool::close() {
  stay_awake([this] { return done(); });
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return done(); });
  for (const auto& worker : workers_) worker->invited = false;
}

bool Pool::done() const {
  const auto taken = [](const Share& share) { return share.empty(); };
  return inside_ == 0 && std::all_of(shares_.begin(), shares_.end(), taken);
}

void Pool::work(std::size_t thread) {
  for (std::size_t i = 0; i < threads_; ++i) {
    Share& share = shares_[(thread + i) % threads_];
    for (std::size_t item = 0; share.take(item);) job_->run(item, thread);
  }
}

void Pool::live(Worker& worker) {
  std::unique_lock lock(mutex_, std::defer_lock);
  for (;;) {
    stay_awake([&] { return stopping_ || worker.invited; });
    lock.lock();
    worker.wake.wait(lock, [&] { return stopping_ || worker.invited; });
    if (stopping_) return;
    worker.invited = false;
    ++inside_;
    lock.unlock();
    work(worker.number);
    lock.lock();
    if (--inside_ == 0) idle_.notify_one();
    lock.unlock();
  }
}

void Pool::stop() noexcept {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  for (const auto& worker : workers_) {
    worker->wake.notify_one();
    worker->thread.reset();
  }
}

}  // namespace mimo
