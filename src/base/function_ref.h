// A callable that somebody else owns: FunctionRef<void(int)>. Unlike std::function it copies nothing and allocates
// nothing; what it refers to outlives it.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace mimo {

template <typename Signature>
class FunctionRef;

template <typename Result, typename... Args>
class FunctionRef<Result(Args...)> {
 public:
  FunctionRef() = default;
  template <typename Function, typename = std::enable_if_t<
                                   !std::is_same_v<std::remove_cv_t<std::remove_reference_t<Function>>, FunctionRef>>>
  FunctionRef(Function&& function) noexcept
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
        call_([](void* object, Args... args) -> Result {
          return (*static_cast<std::remove_reference_t<Function>*>(object))(std::forward<Args>(args)...);
        }) {}

  explicit operator bool() const { return call_ != nullptr; }
  Result operator()(Args... args) const { return call_(object_, std::forward<Args>(args)...); }

 private:
  void* object_ = nullptr;
  Result (*call_)(void* object, Args... args) = nullptr;
};

}  // namespace mimo
