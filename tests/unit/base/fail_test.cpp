#include "base/fail.h"

#include <gtest/gtest.h>

namespace mimo {
namespace {

const std::vector<std::string> kJoints = {"robot:hip_lean1", "robot:left_elbow", "robot:right_elbow", "wheel"};

std::string meant(const std::string& wanted) {
  const std::string said = choice_of(wanted, kJoints);
  const std::string begin = "did you mean \"";
  if (said.compare(0, begin.size(), begin) != 0) return "";
  return said.substr(begin.size(), said.find('"', begin.size()) - begin.size());
}

TEST(Choice, SuggestsNamesWithAPrefix) {
  EXPECT_EQ(meant("left_elbow"), "robot:left_elbow");
  EXPECT_EQ(meant("anna/robot:left_elbow"), "robot:left_elbow");
  EXPECT_EQ(meant("Robot:Left_Elbow"), "robot:left_elbow");
}

TEST(Choice, SuggestsNamesThatDifferByTwoLetters) {
  EXPECT_EQ(meant("robot:left_elbwo"), "robot:left_elbow");
  EXPECT_EQ(meant("weel"), "wheel");
  EXPECT_EQ(meant("hip_lean"), "robot:hip_lean1");
}

TEST(Choice, SuggestsNothingForDistantNames) {
  for (const char* wanted : {"", "x", "elbow", "nobody", ":", "robot:"}) EXPECT_EQ(meant(wanted), "") << wanted;
  EXPECT_EQ(meant(std::string(100000, 'l')), "");
}

TEST(Choice, ListsAllNames) {
  EXPECT_EQ(choice_of("nobody", {"a", "b"}), "there are: a, b");
  EXPECT_EQ(choice_of("wheels", {"wheel"}), "did you mean \"wheel\"? there are: wheel");
  EXPECT_EQ(choice_of("wheel", {}), "there are: none");
  EXPECT_EQ(choice_of("wheel", {"", "x"}), "there are: , x");
}

}  // namespace

}  // namespace mimo
