// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry (LLVM, "libFuzzer – a library for coverage-guided fuzz testing"). Built with SUNDOG_FUZZ=ON and
// clang:
//     pov_fuzzer -dict=tests/fuzz/pov.dict -rss_limit_mb=2000 -max_len=4096 CORPUS tests/fuzz/seeds
#include <cstddef>
#include <cstdint>

#include "pov_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    sundog::fuzz::refusal_of_pov_scene({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
