// The kernels for the baseline, and which sets of kernels this build has for this machine.
#include "base/processor.h"
#include "rays/kernels-inl.h"

namespace mimo::rays {

// Each is compiled in a source of its own, see kernels-inl.h.
namespace N_AVX3 {
void DrawRow(const Grid& grid, int row);
}
namespace N_AVX2 {
void DrawRow(const Grid& grid, int row);
}
namespace N_SSE4 {
void DrawRow(const Grid& grid, int row);
}

std::vector<Path> paths() {
  std::vector<Path> result;
#if HWY_ARCH_X86 && !defined(HWY_COMPILE_ONLY_STATIC)
#if HWY_STATIC_TARGET > HWY_AVX3
  if (has_avx512()) result.push_back({"AVX3", &N_AVX3::DrawRow});
#endif
#if HWY_STATIC_TARGET > HWY_AVX2
  if (has_avx2()) result.push_back({"AVX2", &N_AVX2::DrawRow});
#endif
#if HWY_STATIC_TARGET > HWY_SSE4
  if (has_sse4()) result.push_back({"SSE4", &N_SSE4::DrawRow});
#endif
#endif
  // What the compiler may assume of every machine that this build is for.
  const char* const baseline = HWY_STATIC_TARGET == HWY_EMU128 ? "portable" : hwy::TargetName(HWY_STATIC_TARGET);
  result.push_back({baseline, &HWY_STATIC_DISPATCH(DrawRow)});
  return result;
}

}  // namespace mimo::rays
