#include "batch/threads.h"

namespace mimo::batch {
namespace {

thread_local CurrentThread current;

}  // namespace

LogSink LogQueue::slot() {
  if (!user_) return {};
  return LogSink([this](const LogRecord& record) { keep(record); });
}

void LogQueue::keep(const LogRecord& record) {
  records_.push_back(record);
  if (current_thread().batch != batch_) deliver();  // a user works on this world alone, on a thread of their own
}

void LogQueue::deliver() {
  for (const LogRecord& record : records_) user_(record);
  records_.clear();
}

const CurrentThread& current_thread() { return current; }

bool works_for(const void* batch) {
  const CurrentThread* at = &current;
  while (at != nullptr && at->batch != batch) at = at->of_caller;
  return at != nullptr;
}

AtWork::AtWork(const CurrentThread& at) : before_(current) { current = at; }
AtWork::~AtWork() { current = before_; }

SharedRenderers::SharedRenderers(env::CompiledWorldPtr compiled, std::size_t threads, const void* batch)
    : compiled_(std::move(compiled)), batch_(batch), renderers_(threads) {}

SharedRenderers::RendererPtr SharedRenderers::make() const {
  return env::make_renderer(compiled_->model, compiled_->options, compiled_->services);
}

void SharedRenderers::furnish(std::size_t threads) {
  for (std::size_t i = 0; i < threads; ++i) renderer(i);
}

// A step of the batch takes no lock: its threads have renderers of their own. One that is lost when drawing fails is
// made again.
void SharedRenderers::draw(const mjModel& model, const mjData& data, const render::View& view,
                           const render::Picture& picture) {
  if (current_thread().batch == batch_) return renderer(current_thread().thread).draw(model, data, view, picture);
  RendererPtr borrowed = borrow();
  borrowed->draw(model, data, view, picture);
  give_back(std::move(borrowed));
}

render::Renderer& SharedRenderers::renderer(std::size_t thread) {
  if (renderers_[thread] == nullptr) renderers_[thread] = make();
  return *renderers_[thread];
}

SharedRenderers::RendererPtr SharedRenderers::borrow() {
  {
    const std::lock_guard lock(mutex_);
    if (!lent_.empty()) {
      RendererPtr last = std::move(lent_.back());
      lent_.pop_back();
      return last;
    }
  }
  return make();
}

void SharedRenderers::give_back(RendererPtr renderer) {
  const std::lock_guard lock(mutex_);
  lent_.push_back(std::move(renderer));
}

}  // namespace mimo::batch
