// What recordings need of the operating system.
#pragma once

#include <cstdint>
#include <string>

namespace mimo::recording {

// A library, which stays loaded until it is closed, and what it exports; both null where there is no such thing.
void* open_library(const char* name);
void* symbol_of(void* library, const char* name);
std::string why_not_opened();
void close_library(void* library);

// The file that holds the code of this library; "" where that cannot be known.
std::string path_of_this_library();

// A program with other rights than those of the person who started it, and who chose its environment.
bool has_elevated_rights();
// Whether a variable of the environment begins so.
bool environment_has(const std::string& beginning);

// From now on what is written to an open file goes nowhere.
void write_to_nowhere(int file);

// Keeps a file that is there from all who would write it, or read it by HDF5, until this goes. Not granted where one of
// them was there before.
class Claim {
 public:
  explicit Claim(const std::string& path);
  ~Claim();
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  bool granted() const { return granted_; }

 private:
  std::intptr_t file_;
  bool granted_ = false;
};
// Keeps an open file from all who would write it, until it is closed.
void claim_for_writing(int file);
void end_claim(int file);

// Whether an open file still stands under its name, with no fewer bytes in it than that.
bool stands(int file, const std::string& path, std::uint64_t bytes);
std::uint64_t size_of(int file);

// Whether an open file can be given a name. Else it is made under the one that it keeps.
extern const bool kNamesOpenFiles;
// Gives a file its name. Where `replace` is false, the name must be free. Returns what went wrong, or "".
std::string name_file(const std::string& file, const std::string& name, bool replace);

}  // namespace mimo::recording
