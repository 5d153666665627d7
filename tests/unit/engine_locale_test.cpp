// A host whose locale writes numbers with a comma gets the same models, and keeps its locale.
#include <gtest/gtest.h>
#include <locale.h>
#include <mujoco/mujoco.h>
#include <unistd.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>

#include "support/numbers.h"
#include "support/scenes.h"
#include "support/tiny.h"

// glibc forgets the list of folders that it makes of LOCPATH.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:__argz_add_sep\n"; }

namespace mimo::test {
namespace {

std::string printed(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// A German locale from a folder of our own, for machines that have none installed (Debian package "locales").
class CommaLocale : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string folder = (std::filesystem::temp_directory_path() / "mimo_locale_XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) return;
    folder_ = folder;
    const std::string make = "localedef -i de_DE -f UTF-8 '" + folder + "/de_DE.UTF-8' >/dev/null 2>&1";
    if (std::system(make.c_str()) == 0) ::setenv("LOCPATH", folder.c_str(), 1);
  }
  static void TearDownTestSuite() {
    ::unsetenv("LOCPATH");
    std::filesystem::remove_all(folder_);
  }
  void SetUp() override {
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
      GTEST_SKIP() << "no locale with a decimal comma: de_DE.UTF-8 is not installed and localedef cannot make it";
    }
    ASSERT_EQ(printed(1.5), "1,5");
  }
  void TearDown() override {
    std::setlocale(LC_ALL, "C");
    std::locale::global(std::locale::classic());
  }
  static inline std::string folder_;
};

// 0.05 and 1.25 would be 0 and 1 if the comma counted.
void expect_exact_numbers() {
  scene::Scene scene(
      from_text("<mujoco><worldbody><body name='a' pos='1.25 0.5 -2.75'><geom size='0.05' mass='0.125'/>"
                "</body></worldbody></mujoco>"));
  scene::Object ball;
  ball.name = "ball";
  ball.size[0] = 0.375;
  ball.mass = 2.5;
  ball.pose.position = {0.25, 1.5, -0.125};
  ball.rgba = {1, 1, 1, 1};
  scene.add_object(ball);
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(copy(model->body_pos + 3, 6), (std::vector<double>{1.25, 0.5, -2.75, 0.25, 1.5, -0.125}));
  EXPECT_EQ(copy(model->body_mass + 1, 2), (std::vector<double>{0.125, 2.5}));
  EXPECT_EQ(model->geom_size[0], 0.05);
  EXPECT_EQ(model->geom_size[3], 0.375);
}

void expect_the_infant() {
  scene::Scene scene(from_text("<mujoco><compiler angle='radian'/><include file='mimo/mitten.xml'/></mujoco>"));
  const engine::ModelPtr model = compile(scene);
  EXPECT_TRUE(close(10.90487, model->body_mass[0] + mj_getTotalmass(model.get())));
  const int knee = engine::find_or_fail(*model, engine::Kind::kJoint, "robot:left_knee");
  EXPECT_TRUE(close(-145 * mjPI / 180, model->jnt_range[2 * knee]));
}

TEST_F(CommaLocale, DoesNotMatterInTheProcess) {
  expect_exact_numbers();
  expect_the_infant();
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "de_DE.UTF-8");
  EXPECT_EQ(::uselocale(nullptr), LC_GLOBAL_LOCALE);
  EXPECT_EQ(printed(1.5), "1,5");
}

TEST_F(CommaLocale, DoesNotMatterInTheThread) {
  std::setlocale(LC_ALL, "C");
  const locale_t german = ::newlocale(LC_ALL_MASK, "de_DE.UTF-8", nullptr);
  ASSERT_NE(german, nullptr);
  ::uselocale(german);
  expect_exact_numbers();
  expect_the_infant();
  EXPECT_EQ(::uselocale(nullptr), german);
  ::uselocale(LC_GLOBAL_LOCALE);
  ::freelocale(german);
}

// MuJoCo reads numbers with C++ streams, whose locale is the process's and not ours to change: "0.125" would be 125.
// A model is refused rather than read wrongly.
TEST_F(CommaLocale, OfCppStreamsIsRefused) {
  std::locale::global(std::locale("de_DE.UTF-8"));
  expect_error(Status::kUnsupported, "std::locale::global",
               [] { compiled("<mujoco><worldbody><geom size='0.125'/></worldbody></mujoco>"); });
  EXPECT_EQ(std::locale().name(), "de_DE.UTF-8");
  std::locale::global(std::locale(std::locale("de_DE.UTF-8"), std::locale::classic(), std::locale::numeric));
  expect_exact_numbers();
  expect_the_infant();
}

TEST_F(CommaLocale, OfMessages) {
  engine::Physics physics(compiled(pile(1, "")), {});
  physics.step(4);
  physics.data().qvel[0] = 1e300;
  expect_error(Status::kSimulation, "0.0200 s", [&] { physics.step(1); });
  scene::Scene scene(named("free"));
  EXPECT_EQ(scene.compose().xml.find("0,4"), std::string::npos);
}

}  // namespace
}  // namespace mimo::test
