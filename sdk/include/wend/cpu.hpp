// wend/cpu.hpp -- which vector instructions a plugin may choose among when it is loaded.
#pragma once

namespace wend {

// 1: those of every CPU.  2: AVX2 too.  3: AVX-512 (F, DQ and VL) too.
inline unsigned vector_level() noexcept {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2")) return 1;
  const bool wide =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return wide ? 3 : 2;
#else
  return 1;
#endif
}

}  // namespace wend
