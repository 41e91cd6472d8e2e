// Measures XCS on multiplexers, from an empty rule base on: exploring and exploiting trials in turn, beside the same XCS
// over character strings, and matching alone.
//   bench_xcs [--json]
// Times are a thread's; the two take turns and the least of several turns counts.
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>
#include <wend/testing_time.hpp>

#include "../canonical.hpp"
#include "../test/multiplexer.hpp"
#include "char_strings.hpp"

namespace {

using wend::testing::seconds_of;

xcs::Parameters parameters_of(double limit, double p_hash) {
  xcs::Parameters parameters;
  parameters.limit = limit, parameters.p_hash = p_hash, parameters.theta_mna = 2;
  return parameters;
}

// Trials in pairs; returns how many of the exploiting ones were right.
int learn(const xcs::testing::Multiplexer& world, const xcs::Parameters& parameters, int pairs, std::uint64_t seed) {
  xcs::Population population(world.bits(), 2);
  xcs::Canonical operators(parameters, world.bits(), false);
  xcs::RuleSet match, acted;
  xcs::Predictions predictions;
  population.track(&acted);
  wend::Random random(seed);
  int right = 0;
  for (int t = 0; t < pairs; ++t) {
    xcs::testing::explore(world, operators, population, match, acted, random);
    const std::uint64_t state = world.draw(random);
    population.match(&state, match);
    operators.cover(population, &state, match, random);
    operators.predict(population, match, predictions);
    right += xcs::best_action(predictions.array) == world.answer(state);
  }
  return right;
}

std::string text_of(std::uint64_t state, std::size_t bits) {
  std::string text(bits, '0');
  for (std::size_t j = 0; j < bits; ++j) text[j] = state >> j & 1 ? '1' : '0';
  return text;
}

int learn_with_strings(const xcs::testing::Multiplexer& world, const xcs::Parameters& parameters, int pairs,
                       std::uint64_t seed) {
  peer::CharXcs learner(parameters, seed);
  wend::Random random(seed);
  int right = 0;
  for (int t = 0; t < pairs; ++t) {
    const std::uint64_t explored = world.draw(random), exploited = world.draw(random);
    learner.explore(text_of(explored, world.bits()), [&](int action) {
      return static_cast<std::uint32_t>(action) == world.answer(explored) ? 1000.0 : 0.0;
    });
    right += static_cast<std::uint32_t>(learner.answer(text_of(exploited, world.bits()))) == world.answer(exploited);
  }
  return right;
}

constexpr std::size_t rules = 4096, rule_bits = 20;
constexpr int states = 2000;

template <class Match>
double matched_per_ns(Match&& match) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint64_t turn = 0; turn < 9; ++turn)
    least = std::min(least, seconds_of([&] {
              std::uint64_t state = turn;
              for (int k = 0; k < states; ++k) {
                state = state * 6364136223846793005u + 1442695040888963407u;
                match(state >> (64 - rule_bits));
              }
              return state;
            }));
  return rules * states / least * 1e-9;
}

// Conditions decided a nanosecond: a bit for each rule, no list of them.
double matched(xcs::Kernel kernel) {
  wend::Random random(7);
  xcs::Planes planes(rule_bits);
  planes.words.resize(rules / xcs::Planes::block_rules * rule_bits * 2 * xcs::Planes::block_words);
  for (std::uint64_t& word : planes.words) word = random.word();
  xcs::AlignedWords mask(rules / 64);
  return matched_per_ns([&](std::uint64_t state) {
    match_planes(kernel, planes, planes.blocks(), &state, mask.data());
    asm volatile("" : : "r"(mask.data()) : "memory");
  });
}

double matched_as_strings() {
  wend::Random random(7);
  std::vector<peer::Classifier> list(rules);
  for (peer::Classifier& c : list)
    for (std::size_t j = 0; j < rule_bits; ++j) c.condition += "01##"[random.below(4)];
  std::string text(rule_bits, '0');
  return matched_per_ns([&](std::uint64_t state) {
    for (std::size_t j = 0; j < rule_bits; ++j) text[j] = state >> j & 1 ? '1' : '0';
    std::size_t found = 0;
    for (const peer::Classifier& c : list) found += c.matches(text);
    asm volatile("" : : "r"(found) : "memory");
  });
}

std::vector<std::pair<std::string, double>> measure() {
  std::vector<std::pair<std::string, double>> figures;
  const xcs::testing::Multiplexer eleven{3}, twenty{4};
  const xcs::Parameters small = parameters_of(800, 0.33), large = parameters_of(2000, 0.5);
  constexpr int pairs = 20000, few = 2000, many = 60000;
  double packed = 1e9, packed_few = 1e9, strings_few = 1e9, packed_many = 1e9;
  for (std::uint64_t turn = 0; turn < 7; ++turn) {
    packed = std::min(packed, seconds_of([&] { return learn(eleven, small, pairs, turn); }));
    packed_few = std::min(packed_few, seconds_of([&] { return learn(eleven, small, few, turn); }));
    strings_few = std::min(strings_few, seconds_of([&] { return learn_with_strings(eleven, small, few, turn); }));
  }
  for (std::uint64_t turn = 0; turn < 3; ++turn)
    packed_many = std::min(packed_many, seconds_of([&] { return learn(twenty, large, many, turn); }));
  figures.emplace_back("xcs_pairs_per_s_11mux", pairs / packed);
  figures.emplace_back("xcs_pairs_per_s_20mux", many / packed_many);
  figures.emplace_back("xcs_vs_char_strings_11mux", strings_few / packed_few);
  figures.emplace_back("xcs_matched_per_ns_strings", matched_as_strings());
  figures.emplace_back("xcs_matched_per_ns_scalar", matched(xcs::Kernel::kScalar));
  if (has_kernel(xcs::Kernel::kAvx2)) figures.emplace_back("xcs_matched_per_ns_avx2", matched(xcs::Kernel::kAvx2));
  if (has_kernel(xcs::Kernel::kAvx512)) figures.emplace_back("xcs_matched_per_ns_avx512", matched(xcs::Kernel::kAvx512));
  return figures;
}

}  // namespace

int main(int count, char** arguments) {
  const bool json = count > 1 && std::strcmp(arguments[1], "--json") == 0;
  const char* separator = "{";
  for (const auto& [key, figure] : measure()) {
    if (json)
      std::printf("%s\"%s\": %.6g", separator, key.c_str(), figure);
    else
      std::printf("%-28s %.6g\n", key.c_str(), figure);
    separator = ", ";
  }
  if (json) std::printf("}\n");
}
