// Functions of the user's own, which the library runs: for tasks and senses.
#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "base/processor.h"
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/structs.h"
#include "observation/field.h"

namespace mimo::capi {

// What such code is described by.

constexpr std::size_t kMostParts = 1000;  // terms, fields, parameters: beyond this it is a count that was never set

template <typename T>
Span<T> parts(T* data, std::size_t count, const char* argument) {
  require(count <= kMostParts, "{} has a length of {}, expected up to {}", argument, count, kMostParts);
  return array(data, count, argument);
}

// Calls visit(struct, "task: fields[0]") for each of some structs. A newer caller's are longer than ours: each says
// where the next one begins.
template <typename T, typename Visit>
void for_each_of(const T* structs, std::size_t count, const char* argument, Visit&& visit) {
  const auto* next = reinterpret_cast<const unsigned char*>(parts(structs, count, argument).data());
  for (std::size_t i = 0; i < count; ++i) {
    const auto* theirs = reinterpret_cast<const T*>(next);
    const std::string which = format("{}[{}]", argument, i);
    const T ours = read_struct(theirs, which.c_str());
    require(theirs->struct_size % alignof(T) == 0, "{}: struct_size is {}, expected a multiple of {}", which,
            theirs->struct_size, alignof(T));
    next += theirs->struct_size;
    visit(ours, which);
  }
}

inline void check_path(const std::string& name, const std::string& argument) {
  require(name.front() != '/' && name.back() != '/', "{}: name is \"{}\", expected no / at its ends", argument, name);
}

// Of a field with up to so many numbers.
inline std::vector<std::size_t> shape_of(const std::size_t* shape, std::size_t ndim, std::size_t most,
                                         const std::string& argument) {
  require(ndim <= 4, "{}: ndim is {}, expected up to 4", argument, ndim);
  if (ndim == 0) return {1};
  const Span<const std::size_t> sizes = array(shape, ndim, (argument + ": shape").c_str());
  std::size_t count = 1;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    require(sizes[i] >= 1 && sizes[i] <= most, "{}: shape[{}] is {}, expected 1 to {}", argument, i, sizes[i], most);
    count *= sizes[i];
    require(count <= most, "{}: it has more than {} numbers", argument, most);
  }
  return {sizes.begin(), sizes.end()};
}

// What fields of tasks and senses have in common, but for their names.
template <typename Field>
void describe_field(const Field& field, std::size_t most, const std::string& argument, observation::Field& ours) {
  ours.shape = shape_of(field.shape, field.ndim, most, argument);
  ours.unit = text(field.unit);
  ours.frame = text(field.frame);
  require(field.low < field.high, "{}: low is {} and high is {}, expected low < high", argument, field.low, field.high);
  ours.low = field.low;
  ours.high = field.high;
}

// How it is called.

// Quotes what the function said by mimo_fail, or what the call complained about whose status it returns. The status is
// not handed on: most say that nothing has happened, and the step has.
inline void check_own(mimo_status status, const std::string& whose, const char* function) {
  if (status == MIMO_OK) return;
  const char* why = last_error().status == status ? last_error().text.data() : "";
  fail(Status::kTask, "{}'s function {} returned {} ({}){}{}", whose, function, status, mimo_status_name(status),
       *why == '\0' ? "" : ": ", why);
}

// A C++ program may let exceptions out of its functions. `whose`: "the task".
template <typename Call>
void call_out(const std::string& whose, const char* function, Call&& call) {
  const FreshError of_its_own;
  const PlainFloats plain;  // what it changes of how this thread calculates ends with it
  try {
    check_own(call(), whose, function);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    fail(Status::kTask, "{}'s function {} threw an exception: {}", whose, function, error.what());
  } catch (...) {
    fail(Status::kTask, "{}'s function {} threw an unknown exception", whose, function);
  }
}

}  // namespace mimo::capi
