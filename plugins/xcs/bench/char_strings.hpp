// The peer of the benchmark: the same XCS as most public codes write it.  A classifier is a record, its condition a string
// of characters; every match, search and deletion walks the list of records.  Parameters as in canonical.hpp.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>
#include <wend/random.hpp>

#include "parameters.hpp"

namespace peer {

struct Classifier {
  std::string condition;
  int action = 0;
  double p = 0, error = 0, fitness = 0, set_size = 1;
  int numerosity = 1, experience = 0, stamp = 0;

  bool matches(const std::string& state) const {
    for (std::size_t j = 0; j < condition.size(); ++j)
      if (condition[j] != '#' && condition[j] != state[j]) return false;
    return true;
  }
  bool more_general_than(const Classifier& other) const {
    bool wider = false;
    for (std::size_t j = 0; j < condition.size(); ++j) {
      if (condition[j] != '#' && condition[j] != other.condition[j]) return false;
      wider |= condition[j] != other.condition[j];
    }
    return wider;
  }
};

class CharXcs {
 public:
  CharXcs(const xcs::Parameters& parameters, std::uint64_t seed) : q(parameters), random(seed) {}

  int answer(const std::string& state) {  // exploit
    std::vector<Classifier*> match = cover(state);
    double weighted[2] = {}, fitness[2] = {};
    for (const Classifier* c : match) {
      weighted[c->action] += c->p * c->fitness;
      fitness[c->action] += c->fitness;
    }
    return weighted[1] / fitness[1] > weighted[0] / fitness[0];
  }

  template <class Reward>
  void explore(const std::string& state, Reward&& reward) {
    std::vector<Classifier*> match = cover(state), acted;
    const int action = static_cast<int>(random.below(2));
    for (Classifier* c : match)
      if (c->action == action) acted.push_back(c);
    update(acted, reward(action));
    ++time;
    subsume(acted);
    double stamps = 0, micro = 0;
    for (const Classifier* c : acted) stamps += c->stamp * c->numerosity, micro += c->numerosity;
    if (time - stamps / micro > q.theta_ga) breed(acted, state);
  }

  std::size_t size() const { return population.size(); }

 private:
  bool subsumes(const Classifier& c) const { return c.experience > q.theta_sub && c.error < q.epsilon_0; }

  std::vector<Classifier*> cover(const std::string& state) {
    for (;;) {
      std::vector<Classifier*> match;
      bool has[2] = {};
      for (Classifier* c : population)
        if (c->matches(state)) match.push_back(c), has[c->action] = true;
      if (has[0] && has[1]) return match;
      auto* fresh = new Classifier;
      fresh->condition = state;
      for (char& bit : fresh->condition)
        if (random.chance(q.p_hash)) bit = '#';
      fresh->action = has[0] ? 1 : 0;
      fresh->p = q.prediction_i, fresh->fitness = q.fitness_i, fresh->stamp = time;
      population.push_back(fresh);
      shrink();
    }
  }

  void update(std::vector<Classifier*>& acted, double target) {
    double micro = 0, total = 0;
    for (const Classifier* c : acted) micro += c->numerosity;
    std::vector<double> kappa;
    for (Classifier* c : acted) {
      const double rate = std::max(q.beta, 1.0 / ++c->experience);
      c->error += rate * (std::fabs(target - c->p) - c->error);
      c->p += rate * (target - c->p);
      c->set_size += rate * (micro - c->set_size);
      kappa.push_back((c->error < q.epsilon_0 ? 1 : q.alpha * std::pow(c->error / q.epsilon_0, -q.nu)) * c->numerosity);
      total += kappa.back();
    }
    for (std::size_t k = 0; k < acted.size(); ++k) acted[k]->fitness += q.beta * (kappa[k] / total - acted[k]->fitness);
  }

  void subsume(std::vector<Classifier*>& acted) {
    Classifier* best = nullptr;
    for (Classifier* c : acted)
      if (subsumes(*c) && (!best || c->more_general_than(*best))) best = c;
    if (!best) return;
    for (std::size_t k = 0; k < acted.size();) {
      if (!best->more_general_than(*acted[k])) {
        ++k;
        continue;
      }
      best->numerosity += acted[k]->numerosity;
      drop(acted[k]);
      acted.erase(acted.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

  Classifier* select(const std::vector<Classifier*>& acted) {
    double total = 0;
    for (const Classifier* c : acted) total += c->fitness;
    double left = random.uniform() * total;
    for (Classifier* c : acted)
      if ((left -= c->fitness) < 0) return c;
    return acted.back();
  }

  void breed(std::vector<Classifier*>& acted, const std::string& state) {
    for (Classifier* c : acted) c->stamp = time;
    Classifier* parents[2] = {select(acted), select(acted)};
    Classifier children[2] = {*parents[0], *parents[1]};
    for (Classifier& c : children) c.fitness /= c.numerosity, c.numerosity = 1, c.experience = 0;
    if (random.chance(q.chi)) {
      std::size_t x = random.below(state.size() + 1), y = random.below(state.size() + 1);
      if (x > y) std::swap(x, y);
      for (std::size_t j = x; j < y; ++j) std::swap(children[0].condition[j], children[1].condition[j]);
      for (double Classifier::*number : {&Classifier::p, &Classifier::error, &Classifier::fitness})
        children[0].*number = children[1].*number = (children[0].*number + children[1].*number) / 2;
    }
    for (Classifier& c : children) {
      c.fitness *= q.fitness_reduction;
      for (std::size_t j = 0; j < state.size(); ++j)
        if (random.chance(q.mu)) c.condition[j] = c.condition[j] == '#' ? state[j] : '#';
      if (random.chance(q.mu)) c.action = 1 - c.action;
      insert(c, parents);
    }
    shrink();
  }

  void insert(const Classifier& child, Classifier* const* parents) {
    for (int k = 0; k < 2; ++k)
      if (parents[k]->action == child.action && subsumes(*parents[k]) && parents[k]->more_general_than(child)) {
        ++parents[k]->numerosity;
        return;
      }
    for (Classifier* c : population)
      if (c->action == child.action && c->condition == child.condition) {
        ++c->numerosity;
        return;
      }
    population.push_back(new Classifier(child));
  }

  void shrink() {
    for (;;) {
      double micro = 0, fitness = 0, total = 0;
      for (const Classifier* c : population) micro += c->numerosity, fitness += c->fitness;
      if (micro <= q.limit) return;
      const double mean = fitness / micro;
      const auto vote = [&](const Classifier& c) {
        const double own = c.fitness / c.numerosity, size = c.set_size * c.numerosity;
        return c.experience > q.theta_del && own < q.delta * mean ? size * mean / own : size;
      };
      for (const Classifier* c : population) total += vote(*c);
      double left = random.uniform() * total;
      std::size_t k = 0;
      while (k + 1 < population.size() && (left -= vote(*population[k])) >= 0) ++k;
      if (--population[k]->numerosity == 0) drop(population[k]);
    }
  }

  void drop(Classifier* c) {
    population.erase(std::find(population.begin(), population.end(), c));
    delete c;
  }

 public:
  ~CharXcs() {
    for (Classifier* c : population) delete c;
  }
  CharXcs(const CharXcs&) = delete;
  CharXcs& operator=(const CharXcs&) = delete;

 private:
  xcs::Parameters q;
  wend::Random random;
  std::vector<Classifier*> population;
  int time = 0;
};

}  // namespace peer
