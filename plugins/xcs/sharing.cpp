// Rules that robots publish: see sharing.hpp.
#include "sharing.hpp"

#include <algorithm>

#include "paper_operators.hpp"

namespace xcs {
namespace {

struct Offer {
  std::vector<std::uint64_t> care, value;
  std::uint32_t action;
  Numbers numbers;
  std::size_t robot;
};

bool worth_publishing(const Population& population, std::uint32_t rule, const Parameters& parameters) {
  return population.experience[rule] > parameters.theta_sub && !(population.marks[rule] & kUnsafe) &&
         population.specified(rule) < population.bits();
}

}  // namespace

void publish(std::span<Population* const> populations, const Parameters& parameters) {
  std::vector<Offer> offers;
  for (std::size_t robot = 0; robot < populations.size(); ++robot) {
    const Population& from = *populations[robot];
    for (std::uint32_t rule = 0; rule < from.size(); ++rule)
      if (worth_publishing(from, rule, parameters))
        offers.push_back({{from.care(rule), from.care(rule) + from.words()},
                          {from.value(rule), from.value(rule) + from.words()},
                          from.action(rule),
                          from.numbers(rule),
                          robot});
  }
  std::stable_sort(offers.begin(), offers.end(),
                   [](const Offer& a, const Offer& b) { return a.numbers.experience > b.numbers.experience; });
  for (std::size_t robot = 0; robot < populations.size(); ++robot) {
    Population& to = *populations[robot];
    for (const Offer& offer : offers) {
      if (offer.robot == robot || to.micro() + 1 > parameters.limit) continue;
      if (to.find(offer.care.data(), offer.value.data(), offer.action) != Population::none) continue;
      Numbers numbers = offer.numbers;
      numbers.numerosity = 1;
      numbers.fitness = offer.numbers.fitness / offer.numbers.numerosity;
      numbers.stamp = to.time;
      to.add(offer.care.data(), offer.value.data(), offer.action, numbers);
    }
  }
}

}  // namespace xcs
