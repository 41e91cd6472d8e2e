#include "samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <wend/testing.hpp>

using lspi::Memory;
using wend::testing::error_of;

namespace {

Memory two_samples() {
  Memory memory(2);
  memory.add(std::vector<double>{1, 2}, 1, -0.5, std::vector<double>{3, 4}, false);
  memory.add(std::vector<double>{5, 6}, 0, -1000, std::vector<double>{7, 8}, true);
  return memory;
}

std::string saved(const Memory& memory) {
  std::string bytes;
  const wend_sink sink{sizeof(wend_sink), &bytes, [](void* to, const void* data, std::uint64_t n) -> wend_status {
                         static_cast<std::string*>(to)->append(static_cast<const char*>(data), n);
                         return WEND_OK;
                       }};
  wend::Writer writer(&sink);
  memory.save(writer);
  return bytes;
}
Memory loaded(const std::string& bytes, std::size_t width = 2, std::uint32_t actions = 3) {
  wend::Reader reader(bytes.data(), bytes.size());
  return Memory::load(reader, width, actions);
}

// 1 and the state itself.
std::unique_ptr<lspi::Basis> identity() {
  return lspi::powers({{-1, 1}, {-1, 1}}, 1);
}

}  // namespace

TEST(Memory, GoesThroughTheBasis) {
  const lspi::Samples samples = two_samples().samples(*identity(), nullptr);
  EXPECT_EQ(samples.features, 3u);
  EXPECT_EQ(samples.phi, (std::vector<double>{1, 1, 2, 1, 5, 6}));
  EXPECT_EQ(samples.next_phi, (std::vector<double>{1, 3, 4, 1, 7, 8}));
  EXPECT_EQ(samples.actions, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(samples.rewards, (std::vector<double>{-0.5, -1000}));
  EXPECT_EQ(samples.terminal, (std::vector<std::uint8_t>{0, 1}));
}

TEST(Memory, MirrorsEverySampleOnce) {
  const Memory::Mirror mirror{{1, 0}, {0, 2, 1}};
  const lspi::Samples samples = two_samples().samples(*identity(), &mirror);
  EXPECT_EQ(samples.phi, (std::vector<double>{1, 1, 2, 1, 2, 1, 1, 5, 6, 1, 6, 5}));
  EXPECT_EQ(samples.next_phi, (std::vector<double>{1, 3, 4, 1, 4, 3, 1, 7, 8, 1, 8, 7}));
  EXPECT_EQ(samples.actions, (std::vector<std::uint32_t>{1, 2, 0, 0}));
  EXPECT_EQ(samples.rewards, (std::vector<double>{-0.5, -0.5, -1000, -1000}));
  EXPECT_EQ(samples.terminal, (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

TEST(Memory, SavesAndLoads) {
  const std::string bytes = saved(two_samples());
  const Memory memory = loaded(bytes);
  EXPECT_EQ(memory.size(), 2u);
  EXPECT_EQ(memory.width(), 2u);
  EXPECT_EQ(saved(memory), bytes);
}

TEST(Memory, SavesNothingToo) {
  EXPECT_EQ(loaded(saved(Memory(2))).size(), 0u);
}

TEST(Memory, RefusesAStateThatEndsEarly) {
  const std::string bytes = saved(two_samples());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const std::string error = error_of([&] { loaded(bytes.substr(0, n)); });
    EXPECT_EQ(error.substr(0, 20), "the state ends early") << n;
  }
}

TEST(Memory, RefusesSamplesOfAnotherWidth) {
  EXPECT_EQ(error_of([] { loaded(saved(two_samples()), 3); }), "the samples' arrays have different lengths");
}

TEST(Memory, RefusesAnActionThatThereIsNot) {
  EXPECT_EQ(error_of([] { loaded(saved(two_samples()), 2, 1); }), "a sample has action 1, expected below 1");
}

TEST(Memory, RefusesNumbersThatAreNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Memory memory(1);
    memory.add(std::vector<double>{1}, 0, bad, std::vector<double>{1}, false);
    EXPECT_EQ(error_of([&] { loaded(saved(memory), 1); }), "a sample holds a number that is not finite");
  }
}
