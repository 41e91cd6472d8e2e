// A world, a sensor, a reward, a policy and a learner whose every number can be foretold.  With "log" they tell each
// call.
#include <bit>
#include <cstring>
#include <map>
#include <wend/plugin.hpp>

namespace {

std::string listed(wend::Rows rows) {
  std::string all;
  for (const std::uint32_t row : rows) all += " " + std::to_string(row);
  return all;
}

class Teller {
 public:
  explicit Teller(const wend::Config& config) : host_(config.host()), on_(config.params.flag("log")) {}
  void operator()(const std::string& what) const {
    if (on_) host_->log(host_, 0, what.c_str());
  }

 private:
  const wend_host* host_;
  bool on_;
};

class Counter {
 public:
  explicit Counter(const wend::Config& config)
      : tell_(config),
        ends_(config.params.numbers("ends")),
        pays_(config.params.numbers("pays")),
        breaks_(config.params.text("break")),
        arrive_(config.params.number("arrive")),
        robots_(config.robots()),
        rows_(config.rows()) {
    if (const auto n = config.params.count("actions"))
      action_.discrete("turn", n);
    else
      action_.box("turn", "1", -10, 10);
    seen_.box("x", "1").box("t", "1", 0);
    told_.box("last_x", "1");
  }

  double period() const { return breaks_ == "period" ? 0 : 0.5; }
  const wend::Columns& action(std::uint32_t) const { return action_; }
  const wend::Columns& columns() const { return seen_; }

  void reset(wend::Rows copies, wend::Episodes episodes) {
    std::string seeds;
    for (std::size_t i = 0; i < copies.size(); ++i) {
      seeds += " #" + std::to_string(episodes[i].index) +
               (episodes[i].mode == WEND_TEST           ? " test"
                : episodes[i].mode == WEND_TRAIN_GREEDY ? " greedy"
                                                        : " explore");
      for (std::uint32_t robot = 0; robot < robots_; ++robot)
        rows_[copies[i] * robots_ + robot] = {
            0, 0, static_cast<std::uint64_t>(ends_[(episodes[i].index + robot) % ends_.size()])};
    }
    tell_("reset" + listed(copies) + seeds);
  }

  void step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome> outcomes) {
    tell_("step" + listed(copies));
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      Row& row = rows_[copies[i / robots_] * robots_ + i % robots_];
      if (row.t == row.end) continue;
      const double action = actions[i][0];
      row.x += action;
      ++row.t;
      outcomes[i].reward = breaks_ == "reward" ? 0 / (row.x - row.x)
                           : pays_.empty()     ? action
                                               : pays_[static_cast<std::size_t>(action)];
      if (row.t == row.end) outcomes[i].flags = WEND_TERMINATED | (arrive_ < 0 || action == arrive_ ? WEND_ARRIVED : 0);
    }
  }

  void sense(wend::Rows rows, wend::Matrix<double> out) {
    tell_("sense" + listed(rows));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row& row = rows_[rows[i]];
      const bool now = row.t == 1;
      out[i][0] = row.x;
      if (now && breaks_ == "forget") continue;
      out[i][1] = now && breaks_ == "observation" ? std::numeric_limits<double>::infinity()
                  : now && breaks_ == "range"     ? -1
                                                  : static_cast<double>(row.t);
    }
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_EPISODE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) out[i][0] = rows_[rows[i]].x;
  }

 private:
  struct Row {
    double x = 0;
    std::uint64_t t = 0, end = 0;
  };
  Teller tell_;
  wend::Columns action_, seen_, told_;
  std::vector<double> ends_, pays_;
  std::string breaks_;
  double arrive_;
  std::uint32_t robots_;
  std::vector<Row> rows_;
};

class Eye {
 public:
  explicit Eye(const wend::Config& config)
      : tell_(config),
        noise_(config.params.number("noise")),
        world_(config.use("world")),
        draws_(config.rows(), wend::Random(0)) {
    table_ = static_cast<const wend_sensor*>(world_.type->query(world_.self, WEND_SENSOR));
    columns_.box("x", "1").box("t", "1");
  }
  const wend::Columns& columns() const { return columns_; }
  void begin(wend::Rows rows, wend::Episodes episodes) {
    tell_("begin" + listed(rows));
    for (std::size_t i = 0; i < rows.size(); ++i) draws_[rows[i]] = wend::Random(wend::stream(episodes[i].seed, "eye"));
  }
  void sense(wend::Rows rows, wend::Matrix<double> out) {
    tell_("sense" + listed(rows));
    wend::check(
        table_->sense(world_.self, rows.data(), static_cast<std::uint32_t>(rows.size()), out.data(), out.stride()));
    for (std::size_t i = 0; i < rows.size(); ++i) out[i][0] += noise_ * draws_[rows[i]].uniform();
  }

 private:
  Teller tell_;
  double noise_;
  wend_ref world_;
  const wend_sensor* table_ = nullptr;
  wend::Columns columns_;
  std::vector<wend::Random> draws_;
};

class Pay {
 public:
  explicit Pay(const wend::Config& config)
      : tell_(config),
        reward_(config.params.number("reward")),
        end_(config.params.number("end")),
        nan_(config.params.flag("nan")),
        steps_(config.rows()) {}
  void begin(wend::Rows rows, wend::Episodes) {
    tell_("begin" + listed(rows));
    for (const std::uint32_t row : rows) steps_[row] = 0;
  }
  void score(const wend::Batch& batch, std::span<wend_outcome> outcomes) {
    tell_("score" + listed(batch.rows));
    for (std::size_t i = 0; i < batch.size(); ++i) {
      outcomes[i].reward = nan_ ? -std::numeric_limits<double>::infinity() : reward_;
      outcomes[i].flags |= WEND_COLLIDED;  // the host keeps the world's facts
      if (++steps_[batch.rows[i]] == end_) outcomes[i].flags |= WEND_TERMINATED;
    }
  }

 private:
  Teller tell_;
  double reward_, end_;
  bool nan_;
  std::vector<double> steps_;
};

class Script {
 public:
  explicit Script(const wend::Config& config)
      : tell_(config),
        host_(config.host()),
        params_(config.params),
        script_(config.params.numbers("script")),
        random_(config.params.flag("random")),
        rows_(config.rows()),
        message_(config.params.text("message")) {
    nan_at_ = config.params.number("nan_at"), flip_at_ = config.params.number("flip_at"),
    fail_at_ = config.params.number("fail_at");
    forget_at_ = config.params.number("forget_at");
    actions_ = config.action[0].count;
    told_.box("step", "1");
    if (const auto inner = config.slot("inner")) inner_ = wend::PolicyRef(*inner);
    if (message_ == "at create") throw wend::parameter_error("message", "expected another one, found \"at create\"");
  }
  void begin(wend::Rows rows, wend::Episodes episodes) {
    tell_("begin" + listed(rows));
    for (std::size_t i = 0; i < rows.size(); ++i) rows_[rows[i]] = {0, episodes[i].seed};
    if (inner_) inner_.begin(rows, episodes);
  }
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    tell_("act" + listed(rows));
    if (inner_) return inner_.act(rows, observations.data(), actions.data());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows_[rows[i]];
      const double step = static_cast<double>(row.step);
      double action = random_ ? static_cast<double>(wend::Random(wend::stream(row.seed, row.step)).below(actions_))
                              : script_[row.step % script_.size()];
      if (step == fail_at_) throw wend::Error(message_);
      if (step == nan_at_) action = std::numeric_limits<double>::quiet_NaN();
      if (step == flip_at_) action = std::bit_cast<double>(std::bit_cast<std::uint64_t>(action) ^ 1);
      if (step != forget_at_) actions[i][0] = action;
      ++row.step;
    }
  }
  const wend::Columns* telemetry(std::uint32_t when) const {
    return when == WEND_PER_STEP || when == WEND_PER_EPISODE ? &told_ : nullptr;
  }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) out[i][0] = static_cast<double>(rows_[rows[i]].step);
  }

 private:
  struct Row {
    std::uint64_t step = 0, seed = 0;
  };
  Teller tell_;
  const wend_host* host_;
  wend::Params params_;
  std::vector<double> script_;
  bool random_;
  std::vector<Row> rows_;
  std::string message_;
  double nan_at_, flip_at_, fail_at_, forget_at_;
  std::uint64_t actions_;
  wend::Columns told_;
  wend::PolicyRef inner_;
};

class Table {
 public:
  explicit Table(const wend::Config& config)
      : tell_(config),
        host_(config.host()),
        use_(config.params.number("use")),
        plan_(config.params.numbers("plan")),
        rows_(config.rows()),
        t_(config.observation.index("*.t", "observe")),
        sums_(config.action[0].count),
        counts_(config.action[0].count) {
    told_.box("samples", "1").box("best", "1");
  }
  void begin(wend::Rows rows, wend::Episodes episodes) {
    tell_("begin" + listed(rows));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows_[rows[i]] = episodes[i];
      for (int k = 0; episodes[i].mode == WEND_TEST && k < 2; ++k)  // as a planner does with each plan
        host_->series(host_, "round", k, "plan", k * static_cast<double>(episodes[i].index));
    }
  }
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    tell_("act" + listed(rows));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const wend_episode& episode = rows_[rows[i]];
      const auto step = static_cast<std::uint64_t>(observations[i][t_]);
      actions[i][0] = episode.mode == WEND_TRAIN_EXPLORE
                          ? static_cast<double>(wend::Random(wend::stream(episode.seed, step)).below(sums_.size()))
                          : best_;
    }
  }
  std::uint64_t learn(const wend::Batch& batch) {
    tell_("learn" + listed(batch.rows));
    if (use_ < 0) return batch.size() + 1;
    std::uint64_t used = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const auto t = static_cast<std::uint64_t>(batch.next_observations[i][t_]);
      if (use_ == 0 || t % static_cast<std::uint64_t>(use_) != 0) continue;
      const auto action = static_cast<std::size_t>(batch.actions[i][0]);
      sums_[action] += batch.outcomes[i].reward;
      counts_[action] += 1;
      ++used;
    }
    samples_ += used;
    return used;
  }
  void finish() {
    tell_("finish");
    best_ = 0;
    for (std::size_t a = 1; a < sums_.size(); ++a)
      if (mean(a) > mean(static_cast<std::size_t>(best_))) best_ = static_cast<double>(a);
    if (!plan_.empty()) best_ = plan_[samples_ % plan_.size()];
    host_->series(host_, "rounds", static_cast<double>(samples_), "best_action", best_);
  }
  void save(wend::Writer& writer) const {
    writer.put(std::string_view("test.table 1"));
    writer.put(samples_), writer.put(best_);
    writer.put(std::span<const double>(sums_)), writer.put(std::span<const double>(counts_));
  }
  void load(wend::Reader& reader) {
    reader.expect("test.table 1");
    const auto samples = reader.get<std::uint64_t>();
    const auto best = reader.get<double>();
    auto sums = reader.get_all<double>(), counts = reader.get_all<double>();
    reader.end();
    if (sums.size() != sums_.size() || counts.size() != sums.size())
      throw wend::damaged_state("expected a table of " + std::to_string(sums_.size()) + " actions, found " +
                                std::to_string(sums.size()));
    samples_ = samples, best_ = best, sums_ = sums, counts_ = counts;
  }
  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_UPDATE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows, wend::Matrix<double> out) const {
    out[0][0] = static_cast<double>(samples_), out[0][1] = best_;
  }

 private:
  double mean(std::size_t a) const { return counts_[a] > 0 ? sums_[a] / counts_[a] : 0; }
  Teller tell_;
  const wend_host* host_;
  double use_;
  std::vector<double> plan_;
  std::vector<wend_episode> rows_;
  std::uint32_t t_;
  std::vector<double> sums_, counts_;
  std::uint64_t samples_ = 0;
  double best_ = 0;
  wend::Columns told_;
};

}  // namespace

WEND_PLUGIN(wend::component<Counter>("test.counter"), wend::component<Eye>("test.eye"),
            wend::component<Pay>("test.pay"), wend::component<Script>("test.script"),
            wend::component<Table>("test.table"))
