// The teacher of XCS: see teacher.hpp.
#include "teacher.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace xcs {
namespace {

TeacherOptions read_options(const wend::Params& params) {
  TeacherOptions options;
  options.episodes = params.count("teacher_episodes");
  options.collect = params.count("teacher_collect");
  options.all_strings = params.text("teacher_strings") == "all";
  options.observations = params.count("teacher_observations");
  options.experience = params.number("seed_experience");
  options.fitness = params.number("seed_fitness");
  options.merges = params.flag("seed_merge");
  options.merge_tolerance = params.number("merge_tolerance");
  if (options.collect == 0 && !options.all_strings)
    throw wend::parameter_error("teacher_collect",
                                "expected greedy episodes to collect strings in, found none: ask for some, or take the "
                                "strings of all episodes (teacher_strings)");
  return options;
}

}  // namespace

Teacher::Teacher(const wend::Config& config, wend::Slot slot, const Encoder& encoder, std::uint32_t actions)
    : encoder_(encoder),
      actions_(actions),
      robots_(config.robots()),
      width_(config.observation.width()),
      options_(read_options(config.params)),
      policy_(*slot),
      learner_(*slot),
      values_(*slot),
      string_(encoder.words()) {
  if (!policy_ || !values_) throw wend::unsupported("expected a teacher with " WEND_POLICY " and " WEND_VALUES);
  if (options_.episodes > 0 && !learner_)
    throw wend::parameter_error(
        "teacher_episodes", "expected 0 for a teacher that cannot learn, found " + std::to_string(options_.episodes));
}

// One episode of a copy is one episode, however many robots are in it.  While it collects, the teacher is tested.
void Teacher::begin(wend::Rows rows, wend::Episodes episodes) {
  std::vector<wend_episode> own(episodes.begin(), episodes.end());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (episodes[i].mode == WEND_TEST || progress_.seeded) continue;
    if (rows[i] % robots_ == 0 && episodes[i].mode == WEND_TRAIN_EXPLORE) {
      greedy_ = progress_.taught >= options_.episodes;
      learns_ = !greedy_;
      ++(greedy_ ? progress_.collected : progress_.taught);
    }
    if (greedy_) own[i].mode = WEND_TEST;
  }
  policy_.begin(rows, own);
}

void Teacher::act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) const {
  policy_.act(rows, observations.data(), actions.data());
}

std::uint64_t Teacher::learn(const wend::Batch& batch) {
  if (greedy_ || options_.all_strings)
    for (std::size_t i = 0; i < batch.size(); ++i) keep(batch.observations[i]);
  if (!learns_) return batch.size();
  const wend_batch whole{
      sizeof whole,         static_cast<std::uint32_t>(batch.size()), batch.rows.data(),    batch.observations.data(),
      batch.actions.data(), batch.next_observations.data(),           batch.outcomes.data()};
  return learner_.learn(whole);
}

void Teacher::keep(std::span<const double> observation) {
  encoder_.encode(observation, string_.data());
  std::vector<double>& kept = progress_.strings[string_];
  if (kept.size() < options_.observations * width_) kept.insert(kept.end(), observation.begin(), observation.end());
}

void Teacher::seed(Population& population, double limit, double stamp) const {
  std::vector<std::uint64_t> care(encoder_.words(), ~std::uint64_t{0});
  if (encoder_.bits() % 64 != 0) care.back() = (std::uint64_t{1} << (encoder_.bits() % 64)) - 1;
  std::vector<double> q, spread;
  for (const auto& [string, observations] : progress_.strings) {
    const std::size_t n = observations.size() / width_;
    q.resize(n * actions_), spread.resize(n * actions_);
    values_.values(observations.data(), static_cast<std::uint32_t>(n), q.data(), spread.data());
    for (std::uint32_t a = 0; a < actions_; ++a) {
      double sum = 0, squares = 0, own = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double value = q[i * actions_ + a];
        sum += value, squares += value * value, own += spread[i * actions_ + a] * spread[i * actions_ + a];
      }
      const auto count = static_cast<double>(n);
      const double mean = sum / count, variance = std::max(squares / count - mean * mean, 0.0);
      if (population.find(care.data(), string.data(), a) != Population::none || population.micro() + 1 > limit)
        continue;
      Numbers numbers;
      numbers.prediction = mean, numbers.error = std::sqrt(variance + own / count);
      numbers.fitness = options_.fitness, numbers.experience = options_.experience;
      numbers.set_size = 1, numbers.stamp = stamp, numbers.marks = kSeeded;
      population.add(care.data(), string.data(), a, numbers);
    }
  }
  PaperOptions merging;
  merging.merge_tolerance = options_.merge_tolerance;
  if (options_.merges) merge(population, merging);
}

void Teacher::save(wend::Writer& writer) const {
  writer.put(progress_.taught);
  writer.put(progress_.collected);
  writer.put(static_cast<std::uint8_t>(progress_.seeded));
  writer.put(static_cast<std::uint64_t>(progress_.strings.size()));
  for (const auto& [string, observations] : progress_.strings) {
    writer.put(std::span<const std::uint64_t>(string));
    writer.put(std::span<const double>(observations));
  }
}

Teacher::Progress Teacher::read_progress(wend::Reader& reader) const {
  Progress progress;
  progress.taught = reader.get<std::uint64_t>(), progress.collected = reader.get<std::uint64_t>();
  progress.seeded = reader.get<std::uint8_t>() != 0;
  for (auto n = reader.get<std::uint64_t>(); n > 0; --n) {
    const auto string = reader.get_all<std::uint64_t>();
    auto observations = reader.get_all<double>();
    if (string.size() != encoder_.words() || observations.empty() || observations.size() % width_ != 0)
      throw wend::damaged_state("a teacher's string is not one of this encoding and these observations");
    progress.strings[string] = std::move(observations);
  }
  return progress;
}

}  // namespace xcs
