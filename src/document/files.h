// Files that documents name, which may be anything.
#pragma once

#include <optional>
#include <string>

#include "document/limits.h"

namespace mimo::document {

// Whole content of a file: of those that the limits hold, if they do, else on disk; nothing if there is none. Throws
// Status::kModel for what is no plain file (reading a device, a pipe or a folder may never end), and for one larger
// than the limits allow.
std::optional<std::string> read_file(const std::string& path, const Limits& limits);
std::optional<std::string> read_from_disk(const std::string& path, std::uint64_t most_bytes);
[[noreturn]] void fail_large(const std::string& path, std::uint64_t bytes, std::uint64_t most_bytes);

// Whether a file lies in a folder or below, links followed; "" is the working directory.
bool lies_in(const std::string& path, const std::string& folder);

}  // namespace mimo::document
