// What a batch's threads share and keep apart: messages, renderers, and where each thread is.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "base/log.h"
#include "env/world.h"

namespace mimo::batch {

// What worlds have to say while other threads step them, kept for the thread that called.

class LogQueue {
 public:
  // Of a world of this batch.
  LogQueue(LogSink user, const void* batch) : user_(std::move(user)), batch_(batch) {}

  // The sink that the world gets.
  LogSink slot();
  // Hands everything to the user's sink, on this thread.
  void deliver();

 private:
  void keep(const LogRecord& record);

  LogSink user_;
  const void* batch_;
  std::vector<LogRecord> records_;
};

// Where a thread is: in which batch, on which world, as which of the pool's threads.

struct CurrentThread {
  const void* batch = nullptr;  // null: outside
  std::size_t world = 0;
  std::size_t thread = 0;
  const CurrentThread* of_caller = nullptr;  // of the task that stepped this batch, where one did
};

const CurrentThread& current_thread();
// Whether this thread is at work for a batch: on one of its worlds, or for a task of one that waits for this thread.
bool works_for(const void* batch);

// The thread is at a current_thread as long as this lives.
class AtWork {
 public:
  explicit AtWork(const CurrentThread& at);
  ~AtWork();
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  CurrentThread before_;
};

// The renderers of a batch: one for each thread instead of one for each world. They draw the same, and a thousand
// worlds would otherwise hold a thousand copies of all textures.

// Forwards to a renderer that no other thread uses. Each world of the batch has one instead of its own renderer.
class SharedRenderers : public render::Renderer {
 public:
  // `batch` is the one that it belongs to, as workplaces name it.
  SharedRenderers(env::CompiledWorldPtr compiled, std::size_t threads, const void* batch);
  const env::CompiledWorldPtr& compiled() const { return compiled_; }
  // Makes renderers for the first so many threads now, so that what is missing here shows at once and no step has to.
  void furnish(std::size_t threads);
  void draw(const mjModel& model, const mjData& data, const render::View& view,
            const render::Picture& picture) override;

 private:
  using RendererPtr = std::unique_ptr<render::Renderer>;

  render::Renderer& renderer(std::size_t thread);
  RendererPtr make() const;
  RendererPtr borrow();
  void give_back(RendererPtr renderer);

  env::CompiledWorldPtr compiled_;
  const void* batch_;
  std::vector<RendererPtr> renderers_;  // one per thread of the pool, made when first needed
  // For callers from outside, as many as ever drew at the same time: between the batch's own calls any number of
  // threads may draw, each another world, and so may tasks of other batches.
  std::vector<RendererPtr> lent_;
  std::mutex mutex_;
};

}  // namespace mimo::batch
