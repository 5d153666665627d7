// The block: where fields lie, who fills them, and what that takes.
#include "observation/observer.h"

#include <gtest/gtest.h>

#include <cstring>

#include "base/fail.h"
#include "unit/observation/parts.h"

namespace mimo::observation {
namespace {

using Block = std::vector<std::uint8_t>;

float number(const Block& block, std::size_t at) {
  float value = 0;
  std::memcpy(&value, block.data() + at, sizeof value);
  return value;
}

// 17 floats take 68 bytes, so two lines of 64.
TEST(Layout, PutsEachFieldAtAMultipleOf64Bytes) {
  Signals sense(Share::kTouch, {signal("one", 1), signal("seventeen", 17), signal("last", 2)});
  Observer observer;
  observer.add(sense);
  const Layout& layout = observer.layout();
  ASSERT_EQ(layout.size(), 3u);
  EXPECT_EQ(layout[0].offset, 0u);
  EXPECT_EQ(layout[1].offset, 64u);
  EXPECT_EQ(layout[2].offset, 192u);
  EXPECT_EQ(layout.bytes(), 256u);
}

TEST(Observer, WritesEveryByte) {
  Signals first(Share::kTouch, {signal("a", 2), signal("b", 1, 0.5f)});
  Observer observer;
  observer.add(first);
  observer.add(std::make_unique<Signals>(Share::kTask, std::vector<Signal>{signal("c", 16, 1)}));
  Block block(observer.layout().bytes(), 0xcd);
  for (std::size_t i = 0; i < observer.senses(); ++i) {
    observer.write(i, mjModel_{}, mjData_{2}, block.data(), nullptr);
  }
  observer.layout().clear_gaps(block.data());
  EXPECT_EQ(number(block, 0), 2);
  EXPECT_EQ(number(block, 4), 2);
  EXPECT_EQ(number(block, 64), 2.5f);
  EXPECT_EQ(number(block, 128 + 60), 3);
  for (std::size_t i = 8; i < 64; ++i) EXPECT_EQ(block[i], 0) << i;
  for (std::size_t i = 68; i < 128; ++i) EXPECT_EQ(block[i], 0) << i;
}

TEST(Observer, RefusesDuplicateFieldNames) {
  Signals one(Share::kTouch, {signal("touch/force", 1)}), other(Share::kTask, {signal("touch/force", 2)});
  Observer observer;
  observer.add(one);
  try {
    observer.add(other);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kInvalidArgument);
    EXPECT_EQ(error.message(), "there are two fields \"touch/force\"");
  }
}

TEST(Observer, AddsUpTheTimeOfEachSense) {
  Signals sense(Share::kVestibular, {signal("a", 1)});
  Observer observer;
  observer.add(sense);
  Block block(observer.layout().bytes());
  ShareTimes times{};
  times.fill(1);
  for (int i = 0; i < 100; ++i) observer.write(0, mjModel_{}, mjData_{0}, block.data(), &times);
  EXPECT_GT(times[static_cast<std::size_t>(Share::kVestibular)], 1);
  EXPECT_EQ(times[static_cast<std::size_t>(Share::kTouch)], 1);
  EXPECT_EQ(times[static_cast<std::size_t>(Share::kTask)], 1);
}

TEST(Signals, OmitSignalsWithoutNumbers) {
  Signals sense(Share::kTask, {signal("none", 0), signal("one", 1, 3)});
  ASSERT_EQ(sense.fields().size(), 1u);
  EXPECT_EQ(sense.fields()[0].name, "one");
  Block block(64);
  sense.write(mjModel_{}, mjData_{1}, block.data());
  EXPECT_EQ(number(block, 0), 4);
}

}  // namespace
}  // namespace mimo::observation
