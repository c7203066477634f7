// Callables of any type behind two pointers, for what is called once per light or per node: no allocation, and one
// indirect call. std::function's own exception for empty ones is not there either.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

template <class Signature>
class FunctionRef;

/// Refers to a callable, which must outlive it: an argument's type. Empty, it is false, and must not be called. Plain
/// functions are to be wrapped in a lambda.
template <class R, class... Arguments>
class FunctionRef<R(Arguments...)> {
 public:
  FunctionRef() = default;
  template <class F, std::enable_if_t<!std::is_same_v<std::decay_t<F>, FunctionRef> &&
                                          !std::is_function_v<std::remove_reference_t<F>> &&
                                          std::is_invocable_r_v<R, F&, Arguments...>,
                                      int> = 0>
  FunctionRef(F&& callable) noexcept
      : object_(std::addressof(callable)), call_([](const void* object, Arguments... arguments) -> R {
          using Callable = std::remove_reference_t<F>;
          return (*static_cast<Callable*>(const_cast<void*>(object)))(std::forward<Arguments>(arguments)...);
        }) {}

  explicit operator bool() const { return call_ != nullptr; }
  R operator()(Arguments... arguments) const { return call_(object_, std::forward<Arguments>(arguments)...); }

 private:
  const void* object_ = nullptr;
  R (*call_)(const void*, Arguments...) = nullptr;
};

template <class Signature>
class SharedFunction;

/// Holds a callable, which its copies share; it is called as const, from any thread. Empty, it is false, and must not
/// be called.
template <class R, class... Arguments>
class SharedFunction<R(Arguments...)> {
 public:
  SharedFunction() = default;
  template <class F, std::enable_if_t<!std::is_same_v<std::decay_t<F>, SharedFunction> &&
                                          std::is_invocable_r_v<R, const std::decay_t<F>&, Arguments...>,
                                      int> = 0>
  SharedFunction(F&& callable)
      : object_(std::make_shared<const std::decay_t<F>>(std::forward<F>(callable))),
        call_([](const void* object, Arguments... arguments) -> R {
          return (*static_cast<const std::decay_t<F>*>(object))(std::forward<Arguments>(arguments)...);
        }) {}

  explicit operator bool() const { return call_ != nullptr; }
  R operator()(Arguments... arguments) const { return call_(object_.get(), std::forward<Arguments>(arguments)...); }

 private:
  std::shared_ptr<const void> object_;
  R (*call_)(const void*, Arguments...) = nullptr;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
