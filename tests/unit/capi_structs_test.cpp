// Structs of callers who are older than the library: what they lack counts as zero, whatever the defaults are.
#include <gtest/gtest.h>

#include "capi/structs.h"

namespace mimo::capi {
namespace {

struct Config {
  std::uint32_t struct_size;
  std::uint32_t first;
  std::uint64_t later;
};

}  // namespace

template <>
struct FirstSize<Config> {
  static constexpr std::size_t kBytes = 8;
};

namespace {

constexpr Config kDefaults = {sizeof(Config), 1, 7};

TEST(CapiStructs, FillMissingMembersWithZero) {
  const Config old = {8, 5, 99};  // what lies behind its 8 bytes is not the struct's
  const Config ours = read_struct(&old, kDefaults, "config");
  EXPECT_EQ(ours.first, 5u);
  EXPECT_EQ(ours.later, 0u);
  EXPECT_EQ(ours.struct_size, sizeof(Config));
}

TEST(CapiStructs, NullMeansTheDefaults) { EXPECT_EQ(read_struct<Config>(nullptr, kDefaults, "config").later, 7u); }

TEST(CapiStructs, WriteNothingBeyondAnOldCallersStruct) {
  Config old = {8, 0, 99};
  write_described(&old, {0, 4, 6}, "info");
  EXPECT_EQ(old.first, 4u);
  EXPECT_EQ(old.later, 99u);
  EXPECT_EQ(old.struct_size, 8u);
}

}  // namespace
}  // namespace mimo::capi
