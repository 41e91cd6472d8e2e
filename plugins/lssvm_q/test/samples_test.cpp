#include "samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <wend/random.hpp>
#include <wend/testing.hpp>

using lssvm::Forget;
using lssvm::Window;
using wend::testing::error_of;

namespace {

void add(Window& window, double x, std::uint32_t action, double reward = 0) {
  window.add(std::vector<double>{x, 0}, action, reward, std::vector<double>{x, 1}, false);
}

std::multiset<double> rewards(const Window& window) {
  std::multiset<double> all;
  for (std::size_t i = 0; i < window.size(); ++i) all.insert(window.reward(i));
  return all;
}

std::string saved(const Window& window) {
  std::string bytes;
  const wend_sink sink{sizeof(wend_sink), &bytes, [](void* to, const void* data, std::uint64_t n) -> wend_status {
                         static_cast<std::string*>(to)->append(static_cast<const char*>(data), n);
                         return WEND_OK;
                       }};
  wend::Writer writer(&sink);
  window.save(writer);
  return bytes;
}
Window loaded(const std::string& bytes, std::size_t features = 2, std::size_t limit = 4,
              Forget forget = Forget::redundant, std::uint32_t actions = 3) {
  wend::Reader reader(bytes.data(), bytes.size());
  Window window(features, limit, forget);
  window.load(reader, actions);
  return window;
}

Window four_samples() {
  Window window(2, 4, Forget::redundant);
  add(window, 0, 0, 1), add(window, 1, 0, 2), add(window, 1.1, 0, 3), add(window, 1.1, 2, 4);
  return window;
}

struct Sample {
  double x, y;
  std::uint32_t action;
  int age;
};

// The rule written out: of the closest pair of one action, the older one goes.
void naive_add(std::vector<Sample>& all, std::size_t limit, const Sample& sample) {
  if (all.size() == limit) {
    double least = std::numeric_limits<double>::max();
    std::size_t gone = all.size();
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (i == j || all[i].action != all[j].action) continue;
        const double dx = all[i].x - all[j].x, dy = all[i].y - all[j].y, square = dx * dx + dy * dy;
        if (square < least) {
          least = square;
          gone = all[i].age < all[j].age ? i : j;
        }
      }
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(gone));
  }
  all.push_back(sample);
}

}  // namespace

TEST(Window, TheOldestGivesWay) {
  Window window(2, 3, Forget::oldest);
  for (int i = 0; i < 7; ++i) add(window, 0, 0, i);
  EXPECT_EQ(rewards(window), (std::multiset<double>{4, 5, 6}));
}

TEST(Window, TheOlderOfTheClosestTwoOfOneActionGivesWay) {
  Window window = four_samples();
  add(window, 5, 1, 5);  // 1 and 1.1 of action 0 are closest; 1.1 of action 2 is alone
  EXPECT_EQ(rewards(window), (std::multiset<double>{1, 3, 4, 5}));
  add(window, 6, 1, 6);
  EXPECT_EQ(rewards(window), (std::multiset<double>{3, 4, 5, 6}));  // 0 and 1.1: the older
}

TEST(Window, WhereNoTwoShareAnActionTheOldestGivesWay) {
  Window window(2, 2, Forget::redundant);
  add(window, 0, 0, 1), add(window, 0, 1, 2), add(window, 0, 2, 3);
  EXPECT_EQ(rewards(window), (std::multiset<double>{2, 3}));
}

TEST(Window, KeepsWhatTheRuleWrittenOutKeeps) {
  wend::Random random(3);
  Window window(2, 40, Forget::redundant);
  std::vector<Sample> naive;
  for (int age = 0; age < 600; ++age) {
    const Sample sample{random.normal(), random.normal(), static_cast<std::uint32_t>(random.below(3)), age};
    window.add(std::vector<double>{sample.x, sample.y}, sample.action, age, std::vector<double>{0, 0}, false);
    naive_add(naive, 40, sample);
    std::multiset<double> expected;
    for (const Sample& kept : naive) expected.insert(kept.age);
    ASSERT_EQ(rewards(window), expected) << age;
  }
}

TEST(Window, SavesAndLoadsAndGoesOn) {
  Window window = four_samples();
  const std::string bytes = saved(window);
  Window other = loaded(bytes);
  EXPECT_EQ(saved(other), bytes);
  add(window, 5, 1, 5), add(other, 5, 1, 5);
  EXPECT_EQ(saved(other), saved(window));
}

TEST(Window, RefusesBytesThatAreNotOfIt) {
  const std::string bytes = saved(four_samples());
  for (std::size_t n = 0; n < bytes.size(); ++n)
    EXPECT_EQ(error_of([&] { loaded(bytes.substr(0, n)); }).substr(0, 20), "the state ends early") << n;
  EXPECT_EQ(error_of([&] { loaded(bytes, 3); }), "the samples' arrays have different lengths");
  EXPECT_EQ(error_of([&] { loaded(bytes, 2, 3); }), "expected at most the window's 3 samples, found 4");
  EXPECT_EQ(error_of([&] { loaded(bytes, 2, 4, Forget::oldest); }),
            "expected samples kept by the same rule `forget`, found the other");
  EXPECT_EQ(error_of([&] { loaded(bytes, 2, 4, Forget::redundant, 2); }), "a sample has action 2, expected below 2");
  Window bad(2, 4, Forget::redundant);
  add(bad, 0, 0, std::nan(""));
  EXPECT_EQ(error_of([&] { loaded(saved(bad)); }), "a sample holds a number that is not finite");
}
