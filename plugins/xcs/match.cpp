#include "match.hpp"

namespace xcs {
namespace {

// The kernels are one template over the register that holds the masks, so that they cannot differ but in speed.
typedef std::uint64_t Word;
typedef std::uint64_t Lanes4 __attribute__((vector_size(32), may_alias));
typedef std::uint64_t Lanes8 __attribute__((vector_size(64), may_alias));

constexpr std::size_t pair_words = 2 * Planes::block_words;  // of both planes of a bit

inline std::size_t bit_of(const std::uint64_t* words, std::size_t j) {
  return words[j / 64] >> (j % 64) & 1;
}

template <class Register>
[[gnu::always_inline]] inline void match_in(const Planes& planes, std::size_t blocks, const std::uint64_t* state,
                                            std::uint64_t* mask) {
  constexpr std::size_t registers = Planes::block_words * sizeof(Word) / sizeof(Register);
  std::uint32_t* plane_of = planes.plane_of.data();
  for (std::size_t j = 0; j < planes.bits; ++j)
    plane_of[j] = static_cast<std::uint32_t>(j * pair_words + bit_of(state, j) * Planes::block_words);
  const std::uint64_t* block = planes.words.data();
  for (std::size_t b = 0; b < blocks; ++b, block += planes.bits * pair_words) {
    Register accepted[registers];
    const auto* first = reinterpret_cast<const Register*>(block + plane_of[0]);
    for (std::size_t r = 0; r < registers; ++r) accepted[r] = first[r];
    for (std::size_t j = 1; j < planes.bits; ++j) {
      const auto* plane = reinterpret_cast<const Register*>(block + plane_of[j]);
      for (std::size_t r = 0; r < registers; ++r) accepted[r] &= plane[r];
    }
    auto* out = reinterpret_cast<Register*>(mask + b * Planes::block_words);
    for (std::size_t r = 0; r < registers; ++r) out[r] = accepted[r];
  }
}

// '#' accepts both values, a specified bit its own alone; a number that no rule has accepts neither.
template <class Register>
[[gnu::always_inline]] inline void find_in(const Planes& planes, std::size_t blocks, const std::uint64_t* care,
                                           const std::uint64_t* value, std::uint64_t* mask) {
  constexpr std::size_t registers = Planes::block_words * sizeof(Word) / sizeof(Register);
  const std::uint64_t* block = planes.words.data();
  for (std::size_t b = 0; b < blocks; ++b, block += planes.bits * pair_words) {
    Register same[registers];
    for (std::size_t r = 0; r < registers; ++r) same[r] = ~(Register{} ^ Register{});
    for (std::size_t j = 0; j < planes.bits; ++j) {
      const std::size_t wanted = bit_of(value, j);
      const auto* own = reinterpret_cast<const Register*>(block + j * pair_words + wanted * Planes::block_words);
      const auto* other =
          reinterpret_cast<const Register*>(block + j * pair_words + (1 - wanted) * Planes::block_words);
      const Word specified = 0 - static_cast<Word>(bit_of(care, j));
      for (std::size_t r = 0; r < registers; ++r) same[r] &= own[r] & (other[r] ^ specified);
    }
    auto* out = reinterpret_cast<Register*>(mask + b * Planes::block_words);
    for (std::size_t r = 0; r < registers; ++r) out[r] = same[r];
  }
}

void match_scalar(const Planes& p, std::size_t n, const std::uint64_t* s, std::uint64_t* m) {
  match_in<Word>(p, n, s, m);
}
void find_scalar(const Planes& p, std::size_t n, const std::uint64_t* c, const std::uint64_t* v, std::uint64_t* m) {
  find_in<Word>(p, n, c, v, m);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void match_avx2(const Planes& p, std::size_t n, const std::uint64_t* s,
                                                std::uint64_t* m) {
  match_in<Lanes4>(p, n, s, m);
}
__attribute__((target("avx2"))) void find_avx2(const Planes& p, std::size_t n, const std::uint64_t* c,
                                               const std::uint64_t* v, std::uint64_t* m) {
  find_in<Lanes4>(p, n, c, v, m);
}
__attribute__((target("avx512f"))) void match_avx512(const Planes& p, std::size_t n, const std::uint64_t* s,
                                                     std::uint64_t* m) {
  match_in<Lanes8>(p, n, s, m);
}
__attribute__((target("avx512f"))) void find_avx512(const Planes& p, std::size_t n, const std::uint64_t* c,
                                                    const std::uint64_t* v, std::uint64_t* m) {
  find_in<Lanes8>(p, n, c, v, m);
}
#endif

}  // namespace

bool has_kernel(Kernel kernel) noexcept {
#if defined(__x86_64__)
  if (kernel == Kernel::kAvx2) return __builtin_cpu_supports("avx2");
  if (kernel == Kernel::kAvx512) return __builtin_cpu_supports("avx512f");
#endif
  return kernel == Kernel::kScalar;
}

Kernel best_kernel() noexcept {
  return has_kernel(Kernel::kAvx512) ? Kernel::kAvx512 : has_kernel(Kernel::kAvx2) ? Kernel::kAvx2 : Kernel::kScalar;
}

void match_planes(Kernel kernel, const Planes& planes, std::size_t blocks, const std::uint64_t* state,
                  std::uint64_t* mask) {
#if defined(__x86_64__)
  if (kernel == Kernel::kAvx512) return match_avx512(planes, blocks, state, mask);
  if (kernel == Kernel::kAvx2) return match_avx2(planes, blocks, state, mask);
#endif
  (void)kernel;
  match_scalar(planes, blocks, state, mask);
}

void find_planes(Kernel kernel, const Planes& planes, std::size_t blocks, const std::uint64_t* care,
                 const std::uint64_t* value, std::uint64_t* mask) {
#if defined(__x86_64__)
  if (kernel == Kernel::kAvx512) return find_avx512(planes, blocks, care, value, mask);
  if (kernel == Kernel::kAvx2) return find_avx2(planes, blocks, care, value, mask);
#endif
  (void)kernel;
  find_scalar(planes, blocks, care, value, mask);
}

}  // namespace xcs
