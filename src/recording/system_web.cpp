// A module of WebAssembly loads no libraries, so there is no HDF5 and no recording: nothing else here is ever called.
#include "base/fail.h"
#include "recording/system.h"

namespace mimo::recording {

void* open_library(const char*) {
  fail(Status::kUnsupported,
       "recordings need the library HDF5, which a WebAssembly module cannot load; record with the library of another "
       "system");
}
void* symbol_of(void*, const char*) { return nullptr; }
std::string why_not_opened() { return ""; }
void close_library(void*) {}

std::string path_of_this_library() { return ""; }
bool has_elevated_rights() { return false; }
bool environment_has(const std::string&) { return false; }
void write_to_nowhere(int) {}

Claim::Claim(const std::string&) : file_(-1), granted_(file_ >= 0) {}
Claim::~Claim() = default;
void claim_for_writing(int) {}
void end_claim(int) {}

bool stands(int, const std::string&, std::uint64_t) { return false; }
std::uint64_t size_of(int) { return 0; }

const bool kNamesOpenFiles = false;
std::string name_file(const std::string&, const std::string&, bool) { return "there are no files"; }

}  // namespace mimo::recording
