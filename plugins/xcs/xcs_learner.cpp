#include "xcs_learner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "canonical.hpp"
#include "paper_operators.hpp"

namespace xcs {

Xcs::Xcs(const wend::Config& config, const std::string& name)
    : Learner(config, name), trace_(config.params.number("trace")), course_(config.rows()) {
  if (config.params.text("operators") == "paper") {
    make_ = paper_operators(config, parameters_);
  } else {
    make_ = [parameters = parameters_, bits = encoder_.bits(), compacts = config.params.flag("compact")] {
      return std::make_unique<Canonical>(parameters, bits, compacts);
    };
  }
  for (auto& base : bases_) base->discovery = make_();
  if (const wend::Slot slot = config.slot("teacher"))
    teacher_ = std::make_unique<Teacher>(config, slot, encoder_, actions_);
}

void Xcs::begin(wend::Rows rows, wend::Episodes episodes) {
  Learner::begin(rows, episodes);
  for (const std::uint32_t row : rows) course_[row].clear();
  if (!teacher_ || !teacher_->acting()) return;
  if (teacher_->ready() && episodes[0].mode != WEND_TEST) return seed_from_teacher();
  teacher_->begin(rows, episodes);
}

void Xcs::seed_from_teacher() {
  for (auto& base : bases_) teacher_->seed(base->population, parameters_.limit, base->population.time);
  teacher_->seeded();
}

void Xcs::act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
  if (teacher_ && teacher_->acting()) return teacher_->act(rows, observations, actions);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    decide(rows[i], observations[i]);
    actions[i][0] = rows_[rows[i]].action;
  }
}

// [P] -> [M] -> PA -> action -> [A].
void Xcs::decide(std::uint32_t index, std::span<const double> observation) {
  Row& row = rows_[index];
  Base& base = base_of(index);
  encoder_.encode(observation, row.state.data());
  base.population.match(row.state.data(), match_);
  if (learns(row))
    base.discovery->cover(base.population, row.state.data(), match_, row.random);
  else if (match_.empty() && takes_nearest())
    base.population.nearest(row.state.data(), match_);
  base.discovery->predict(base.population, match_, predictions_);
  row.action = choose(row, predictions_.array);
  row.prediction = predictions_.array[row.action];
  row.matching = static_cast<double>(match_.size());
  advocates(base.population, match_, row.action, row.acted);
  row.decided = true;
}

std::uint64_t Xcs::learn(const wend::Batch& batch) {
  if (teacher_ && teacher_->acting()) return teacher_->learn(batch);
  std::uint64_t used = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const std::uint32_t index = batch.rows[i];
    if (!learns(rows_[index])) continue;
    const auto from = batch.observations[i], to = batch.next_observations[i];
    for (const auto& seen : {from, to})
      encoder_.encode(seen, rows_[index].next.data());  // fails before anything changes
    Transition transition{{from.begin(), from.end()},
                          {to.begin(), to.end()},
                          action_of(batch.actions[i]),
                          checked_reward(batch.outcomes[i].reward),
                          batch.outcomes[i].flags};
    ++used;
    if (trace_ > 0) {
      course_[index].push_back(std::move(transition));
      if (batch.outcomes[i].flags & (WEND_TERMINATED | WEND_TRUNCATED)) replay(index);
      continue;
    }
    double after = std::numeric_limits<double>::quiet_NaN();
    if (!take(index, transition, after)) --used;
  }
  return used;
}

// An episode from its end to its start, with the lambda-return in place of the next state's best prediction.
void Xcs::replay(std::uint32_t index) {
  double after = std::numeric_limits<double>::quiet_NaN();
  std::vector<Transition>& course = course_[index];
  for (std::size_t k = course.size(); k-- > 0;) take(index, course[k], after);
  course.clear();
}

// Learns from one transition.  `after` is the return from s' on, or NaN where only PA tells it; it becomes that from s
// on.
bool Xcs::take(std::uint32_t index, const Transition& transition, double& after) {
  Row& row = rows_[index];
  Base& base = base_of(index);
  Experience experience;
  experience.action = transition.action;
  experience.reward = transition.reward;
  experience.flags = transition.flags;
  experience.observation = transition.observation;
  experience.next_observation = transition.next;
  experience.explored = row.mode == WEND_TRAIN_EXPLORE;
  const bool continues = !(transition.flags & WEND_TERMINATED) && parameters_.gamma > 0;
  const double best = continues ? best_after(row, base, transition.next) : 0;
  if (!find_acted(row, base, transition.observation, transition.action)) return false;
  experience.state = row.state.data();
  experience.target = experience.reward;
  if (continues) {
    const bool known = !std::isnan(after) && !(transition.flags & WEND_HANDED_OVER);
    experience.target += parameters_.gamma * (known ? (1 - trace_) * best + trace_ * after : best);
  }
  after = experience.target;
  const double generation = base.population.generations;
  base.discovery->update(base.population, experience, row.acted);
  base.discovery->discover(base.population, experience, row.acted, row.random);
  row.decided = false;
  row.acted.clear();
  tell_generation(base.population, generation);
  learned_one();
  return true;
}

// [A] of a transition: the one of the row's last decision, or a new one where somebody else decided.
bool Xcs::find_acted(Row& row, Base& base, std::span<const double> observation, std::uint32_t action) {
  encoder_.encode(observation, row.next.data());
  if (row.decided && row.action == action && row.next == row.state && !row.acted.empty()) return true;
  row.state = row.next;
  base.population.match(row.state.data(), match_);
  base.discovery->cover(base.population, row.state.data(), match_, row.random);
  advocates(base.population, match_, action, row.acted);
  held_ = {&base, base.population.version(), row.state, match_};
  return !row.acted.empty();
}

// max PA of the state that follows, with rules for it.
double Xcs::best_after(Row& row, Base& base, std::span<const double> next) {
  encoder_.encode(next, row.next.data());
  if (held_.base == &base && held_.version == base.population.version() && held_.state == row.next) {
    match_ = held_.match;
  } else {
    base.population.match(row.next.data(), match_);
    base.discovery->cover(base.population, row.next.data(), match_, row.random);
  }
  base.discovery->predict(base.population, match_, predictions_);
  const std::uint32_t best = best_action(predictions_.array);
  return best < actions_ ? predictions_.array[best] : 0;
}

void Xcs::finish() {
  if (teacher_ && teacher_->ready()) seed_from_teacher();
  for (auto& base : bases_) base->discovery->finish(base->population);
}

void Xcs::save_more(wend::Writer& writer) const {
  writer.put(static_cast<std::uint8_t>(teacher_ != nullptr));
  if (teacher_) teacher_->save(writer);
}

// What is read is taken over when the whole state has turned out to be good.
std::function<void()> Xcs::load_more(wend::Reader& reader) {
  if (reader.get<std::uint8_t>() == 0) return [] {};
  if (!teacher_) throw wend::damaged_state("expected a state without a teacher, found one with a teacher in its slot");
  auto progress = std::make_shared<Teacher::Progress>(teacher_->read_progress(reader));
  return [this, progress] { teacher_->restore(std::move(*progress)); };
}

}  // namespace xcs
