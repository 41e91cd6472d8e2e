// Measures the arena through its C table: ns a ray, steps a second of a robot with six beams, and allocations a step,
// in thread CPU time without resets.
//   bench_arena [--json] [obstacles]
#include <cstring>

#include "course.hpp"

extern "C" void* __libc_malloc(std::size_t);
extern "C" void* __libc_calloc(std::size_t, std::size_t);
extern "C" void* __libc_realloc(void*, std::size_t);
extern "C" void* __libc_memalign(std::size_t, std::size_t);

namespace {

std::uint64_t allocations = 0;

}  // namespace

// Every allocation of the process, operator new's too, comes through these.
extern "C" {
void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* from, std::size_t size) {
  ++allocations;
  return __libc_realloc(from, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
}

namespace {

double allocations_per_step(bench::Loop& loop, int batches) {
  std::uint64_t counted = 0;
  for (int k = 0; k < batches; ++k) {
    const std::uint64_t before = allocations;
    loop.sense();
    loop.move();
    counted += allocations - before;
    loop.restart_ended();
  }
  return static_cast<double>(counted) / (batches * static_cast<double>(bench::copies));
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  std::vector<int> counts{0, 20, 200, 1000, 10000};
  if (argc > 1 + json) counts = {std::atoi(argv[1 + json])};
  std::vector<std::pair<std::string, double>> figures;
  double allocated = 0;
  for (const int n : counts) {
    bench::Arena arena(n);
    bench::Loop loop(arena);
    double whole = 1, rays = 1;
    for (int k = 0; k < 5; ++k) {
      loop.sensing = loop.driving = true;
      whole = std::min(whole, loop.measure(0.3));
      loop.driving = false;
      rays = std::min(rays, loop.measure(0.1));
    }
    figures.emplace_back("arena_steps_per_s_" + std::to_string(n), 1 / whole);
    figures.emplace_back("arena_ns_per_ray_" + std::to_string(n), 1e9 * rays / bench::beams);
    allocated = std::max(allocated, allocations_per_step(loop, 2000));
  }
  figures.emplace_back("allocations_per_step", allocated);
  bench::print(figures, json);
}
