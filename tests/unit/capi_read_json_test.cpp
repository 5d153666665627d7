// JSON texts of recordings: what they mean, what is refused, and that the process lives on where memory runs out.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "capi/read_json.h"

#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // of malloc and free, which make the pair

namespace {

std::size_t left = SIZE_MAX;  // allocations before memory has run out

}  // namespace

void* operator new(std::size_t size) {
  if (left == 0) throw std::bad_alloc();
  --left;
  void* const memory = std::malloc(size);
  return memory != nullptr ? memory : throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace mimo::capi {
namespace {

constexpr const char* kCalls =
    R"([{"call": "add_agent", "config": {"position": [1, -2, 0.5], "name": null}}, true, []])";

TEST(ReadJson, HasTheValuesOfItsText) {
  const std::optional<ReadJson> calls = read_json(kCalls);
  ASSERT_TRUE(calls && calls->is(ReadJson::Kind::kList));
  ASSERT_EQ(calls->parts.size(), 3U);
  EXPECT_EQ(calls->parts[0].find("call")->text, "add_agent");
  EXPECT_EQ(calls->parts[0].find("nothing"), nullptr);
  const ReadJson& config = *calls->parts[0].find("config");
  EXPECT_TRUE(config.find("name")->is(ReadJson::Kind::kNull));
  const std::vector<ReadJson>& position = config.find("position")->parts;
  EXPECT_EQ(position[0].number<double>(), 1.0);
  EXPECT_EQ(position[1].number<std::int32_t>(), -2);
  EXPECT_EQ(position[1].number<std::uint32_t>(), std::nullopt);
  EXPECT_EQ(position[2].number<double>(), 0.5);
  EXPECT_EQ(position[2].number<std::int32_t>(), std::nullopt);
  EXPECT_TRUE(calls->parts[1].is(ReadJson::Kind::kFlag));
}

TEST(ReadJson, KnowsTheRangesOfTypes) {
  const ReadJson json = *read_json("[2147483648, -2147483648, 18446744073709551615, -1]");
  EXPECT_EQ(json.parts[0].number<std::int32_t>(), std::nullopt);
  EXPECT_EQ(json.parts[0].number<std::uint32_t>(), 2147483648U);
  EXPECT_EQ(json.parts[1].number<std::int32_t>(), INT32_MIN);
  EXPECT_EQ(json.parts[2].number<std::uint64_t>(), UINT64_MAX);
  EXPECT_EQ(json.parts[2].number<std::int64_t>(), std::nullopt);
  EXPECT_EQ(json.parts[3].number<std::size_t>(), std::nullopt);
}

TEST(ReadJson, RefusesWhatIsNone) {
  for (const char* text : {"", "[1,]", "{\"a\": }", "[1] 2", "nan"}) EXPECT_FALSE(read_json(text)) << text;
  EXPECT_FALSE(read_json(std::string(100000, '[')));
  EXPECT_TRUE(read_json(std::string(32, '[') + std::string(32, ']')));
  EXPECT_FALSE(read_json(std::string(33, '[') + std::string(33, ']')));
}

// Whatever has been read by then is destroyed without asking for memory, which would end the process.
TEST(ReadJson, SurvivesThatMemoryRunsOut) {
  const std::string text = std::string("[") + kCalls + "," + kCalls + "]";
  bool parsed = false;
  for (std::size_t granted = 0; !parsed; ++granted) {
    bool failed = false;
    left = granted;
    try {
      const std::optional<ReadJson> json = read_json(text);
      left = 0;
      parsed = json.has_value();
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    left = SIZE_MAX;
    ASSERT_TRUE(parsed || failed) << granted;
    ASSERT_LT(granted, 1000U);
  }
}

}  // namespace
}  // namespace mimo::capi
