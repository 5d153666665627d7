// Files that get their names when they are whole.
#include "base/new_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

namespace mimo::test {
namespace {

namespace fs = std::filesystem;

class NewFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const fs::path folder_ = fs::temp_directory_path() / ("mimo_new_file_" + std::to_string(getpid()));
};

TEST_F(NewFile, NamesBesideAFileAreInItsFolderAndDiffer) {
  const fs::path one = beside(folder_ / "run.h5", ".h5"), other = beside(folder_ / "run.h5", ".h5");
  EXPECT_EQ(one.parent_path(), folder_);
  EXPECT_EQ(one.extension(), ".h5");
  EXPECT_NE(one, other);
  EXPECT_EQ(beside("run.h5").parent_path(), "");
}

TEST_F(NewFile, AFreeNameIsTaken) {
  const fs::path made = write("made", "whole");
  EXPECT_FALSE(move_to_free(made, folder_ / "name"));
  EXPECT_EQ(read(folder_ / "name"), "whole");
  EXPECT_FALSE(fs::exists(made));
}

TEST_F(NewFile, ANameThatIsTakenStays) {
  const fs::path made = write("made", "whole"), taken = write("taken", "of others"), link = folder_ / "link";
  fs::create_symlink("nowhere", link);
  fs::create_directory(folder_ / "folder");
  for (const fs::path& name : {taken, link, folder_ / "folder"}) {
    EXPECT_EQ(move_to_free(made, name), std::errc::file_exists) << name;
    EXPECT_EQ(read(made), "whole");
  }
  EXPECT_EQ(read(taken), "of others");
  EXPECT_TRUE(fs::is_symlink(link));
}

TEST_F(NewFile, ReportsAMissingFile) {
  EXPECT_EQ(move_to_free(folder_ / "made", folder_ / "name"), std::errc::no_such_file_or_directory);
}

}  // namespace
}  // namespace mimo::test
