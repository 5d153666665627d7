// Exceptions where none may pass: as a status and a text.
#pragma once

#include <exception>
#include <new>

#include "base/fail.h"

namespace mimo {

// Calls work(), and failed(status, text) with what it throws.
template <typename Work, typename Failed>
void caught(Work&& work, Failed&& failed) noexcept {
  try {
    work();
  } catch (const Error& error) {
    failed(error.status(), error.what());
  } catch (const std::bad_alloc&) {
    failed(Status::kOutOfMemory, "out of memory");
  } catch (const std::exception& error) {
    failed(Status::kInternal, error.what());
  } catch (...) {
    failed(Status::kInternal, "an unknown exception");
  }
}

}  // namespace mimo
