// Proof that a library minds its manners: while a Quiet lives, stdout and stderr go to files and the working directory
// is an empty folder; noise() tells what was printed and which files appeared.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace mimo::test {

class Quiet {
 public:
  Quiet() : home_(std::filesystem::current_path()) {
    std::string folder = (std::filesystem::temp_directory_path() / "mimo_quiet_XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) std::abort();
    folder_ = folder;
    std::filesystem::current_path(folder_);
    std::fflush(nullptr);
    for (const int fd : {1, 2}) {
      files_[fd - 1] = std::tmpfile();
      saved_[fd - 1] = ::dup(fd);
      ::dup2(::fileno(files_[fd - 1]), fd);
    }
  }

  ~Quiet() { noise(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  // Ends the silence. "" if nothing was printed and no file appeared.
  std::string noise() {
    if (over_) return noise_;
    over_ = true;
    std::fflush(nullptr);
    for (const int fd : {1, 2}) {
      ::dup2(saved_[fd - 1], fd);
      ::close(saved_[fd - 1]);
      noise_ += content(files_[fd - 1]);
      std::fclose(files_[fd - 1]);
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      noise_ += "file " + entry.path().filename().string() + "\n";
    }
    std::filesystem::current_path(home_);
    std::filesystem::remove_all(folder_);
    return noise_;
  }

 private:
  static std::string content(std::FILE* file) {
    std::string text;
    std::rewind(file);
    for (int c; (c = std::fgetc(file)) != EOF;) text += static_cast<char>(c);
    return text;
  }

  std::filesystem::path home_, folder_;
  std::FILE* files_[2] = {};
  int saved_[2] = {};
  bool over_ = false;
  std::string noise_;
};

// Every test of a fixture that derives from this must be quiet. (Failed expectations print, and are shown as noise.)
class QuietTest : public ::testing::Test {
 protected:
  void TearDown() override { EXPECT_EQ(quiet_.noise(), ""); }
  Quiet quiet_;
};

}  // namespace mimo::test
