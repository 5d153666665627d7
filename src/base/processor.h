// Which instruction sets this processor has and its system saves; for x86 only.
#pragma once

namespace mimo {

bool has_sse4();  // SSE4.2 and PCLMUL
bool has_avx();
bool has_avx2();    // with FMA and BMI2
bool has_avx512();  // F, VL, DQ, BW and CD

}  // namespace mimo
