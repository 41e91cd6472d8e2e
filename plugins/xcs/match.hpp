// Matching by transposed conditions.  For every bit of the state and each of its two values a plane holds one bit a
// rule: 1 where the rule accepts that value there.  A state's match set is the conjunction of one plane a bit, so one
// instruction of 512 bits decides a bit for 512 rules.  All kernels give the same mask, bit for bit.
#pragma once
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace xcs {

enum class Kernel { kScalar, kAvx2, kAvx512 };

// The fastest kernel that this CPU has, and whether it has a given one.
Kernel best_kernel() noexcept;
bool has_kernel(Kernel kernel) noexcept;

template <class T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) noexcept {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64})); }
  void deallocate(T* p, std::size_t) noexcept { ::operator delete (p, std::align_val_t{64}); }
  bool operator==(const CacheLineAllocator&) const noexcept { return true; }
};

using AlignedWords = std::vector<std::uint64_t, CacheLineAllocator<std::uint64_t>>;

// Blocks of 512 rules; in a block, for bit j and value v, eight words at ((block * bits + j) * 2 + v) * 8.
struct Planes {
  static constexpr std::size_t block_rules = 512, block_words = 8;
  explicit Planes(std::size_t n) : bits(n), plane_of(n) {}
  std::size_t bits;
  AlignedWords words;
  mutable std::vector<std::uint32_t> plane_of;  // scratch of a match: for each bit where in a block its plane is
  std::size_t blocks() const noexcept { return bits ? words.size() / (bits * 2 * block_words) : 0; }
};

// mask: 8 words a block, aligned as the planes are; bit r of block b is rule 512 b + r.
void match_planes(Kernel kernel, const Planes& planes, std::size_t blocks, const std::uint64_t* state,
                  std::uint64_t* mask);

// As match_planes, but of the rules whose condition is exactly this one.
void find_planes(Kernel kernel, const Planes& planes, std::size_t blocks, const std::uint64_t* care,
                 const std::uint64_t* value, std::uint64_t* mask);

}  // namespace xcs
