// One of the ways to come by OpenGL: a library that is loaded at run time, and contexts of its making.
#pragma once

#include <memory>

#include "base/fail.h"

namespace mimo::opengl {

// A context with the smallest buffer that it can have: MuJoCo draws into another.
class Handle {
 public:
  virtual ~Handle() = default;
  // On this thread, where no other is. Throws Status::kRender.
  virtual void make_current() = 0;
  virtual void release() noexcept = 0;
};

class Platform {
 public:
  virtual ~Platform() = default;
  virtual const char* name() const = 0;  // as users know it: "OSMesa"
  // The function by which it finds OpenGL's functions, and what MuJoCo knows that by.
  virtual void* finder() const = 0;
  virtual const char* finder_name() const = 0;
  // What `finder` finds; null for nothing.
  virtual void* find(const char* function) const = 0;
  // Throws Status::kRender.
  virtual std::unique_ptr<Handle> make_handle() const = 0;
};
using PlatformPtr = std::shared_ptr<const Platform>;

// Makes a function of what was found under a name. Throws Status::kUnsupported where that is nothing.
template <typename Function, typename Address>
void assign(Function& function, Address found, const char* library, const char* name) {
  if (found == nullptr) fail(Status::kUnsupported, "the installed {} has no function {}", library, name);
  function = reinterpret_cast<Function>(found);
}

}  // namespace mimo::opengl
