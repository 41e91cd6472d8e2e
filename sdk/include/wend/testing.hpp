// wend/testing.hpp -- a host in miniature: creates one component with the parameters, spaces, slots and uses that a
// test gives it, and calls it through its C tables, as wend does.
//
//   wend::testing::Bench bench(wend::component<Greedy>("my.greedy"));
//   bench.set("gain", 2).observation(columns).action(table).use("world", world.ref());
//   ASSERT_TRUE(bench.create()) << bench.error();
//   bench.begin(7);
//   EXPECT_EQ(bench.act({0.5, 1.0}), std::vector<double>{1});
//
// A call that fails throws std::runtime_error with the component's message.
#pragma once
#include <deque>
#include <initializer_list>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>
#include <wend/component.hpp>
#include <wend/random.hpp>
#include <wend/space.hpp>

namespace wend::testing {

class Bench {
 public:
  explicit Bench(const wend_component& component) : component_(component) {
    host_.size = sizeof(wend_host);
    host_.fail = [](const wend_host* host, wend_status code, const char* param, const char* message) {
      Bench& bench = of(host);
      bench.error_ = message ? message : "";
      bench.parameter_ = param ? param : "";
      return code;
    };
    host_.log = [](const wend_host* host, std::uint32_t level, const char* message) {
      of(host).logged.push_back({level, message});
    };
    host_.random = [](const wend_host*, std::uint64_t key, std::uint64_t counter, double* out, std::uint64_t n) {
      uniform(key, counter, out, n);
    };
    host_.stream = [](const wend_host*, std::uint64_t parent, const char* name) {
      return wend::stream(parent, std::string_view(name));
    };
    host_.series = [](const wend_host* host, const char* x_name, double x, const char* y_name, double y) {
      of(host).series.push_back({std::string(x_name) + "/" + y_name, {x, y}});
    };
    host_.extension = [](const wend_host*, const char*) -> const void* { return nullptr; };
  }
  ~Bench() { destroy(); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  // ---- what it is created with
  template <class Number>
  requires std::is_arithmetic_v<Number> Bench& set(const std::string& path, Number number) {
    return values_[path] = {static_cast<double>(number), "", false}, *this;
  }
  Bench& set(const std::string& path, const std::string& text) { return values_[path] = {0, text, true}, *this; }
  Bench& set(const std::string& path, const char* text) { return set(path, std::string(text)); }
  template <class Value>
  Bench& set(const std::string& path, std::initializer_list<Value> all) {
    unset(path);
    std::size_t i = 0;
    for (const Value& value : all) set(Params::element(path, i++), value);
    return *this;
  }
  Bench& unset(const std::string& path) {  // and all below it
    std::erase_if(values_,
                  [&](const auto& value) { return value.first == path || value.first.rfind(path + "/", 0) == 0; });
    return *this;
  }
  Bench& robot(const std::string& path, double number) { return robot_[path] = {number, "", false}, *this; }
  Bench& robot(const std::string& path, const char* text) { return robot_[path] = {0, text, true}, *this; }
  Bench& observation(const Columns& columns) { return observation_ = columns.table(), *this; }
  Bench& action(const Columns& columns) { return action_ = columns.table(), *this; }
  Bench& observation(const wend_space* space) { return observation_ = space, *this; }
  Bench& action(const wend_space* space) { return action_ = space, *this; }
  Bench& slot(const std::string& name, wend_ref ref) { return slots_.emplace_back(name, ref), *this; }
  Bench& use(const std::string& name, wend_ref ref) { return uses_.emplace_back(name, ref), *this; }
  Bench& copies(std::uint32_t n) { return copies_ = n, *this; }
  Bench& robots(std::uint32_t n) { return robots_ = n, *this; }
  Bench& seed(std::uint64_t seed) { return seed_ = seed, *this; }

  // False where the component refused: see error() and parameter().
  bool create() {
    destroy();
    const auto values = flat(values_), robot = flat(robot_);
    const auto slots = named(slots_), uses = named(uses_);
    wend_config config{};
    config.size = sizeof config;
    config.copies = copies_, config.robots = robots_;
    config.value_count = static_cast<std::uint32_t>(values.size());
    config.robot_value_count = static_cast<std::uint32_t>(robot.size());
    config.slot_count = static_cast<std::uint32_t>(slots.size());
    config.use_count = static_cast<std::uint32_t>(uses.size());
    config.values = values.data(), config.params = "{}", config.robot_values = robot.data(), config.robot = nullptr;
    config.slots = slots.data(), config.uses = uses.data(), config.seed = seed_;
    config.observation = observation_, config.action = action_;
    error_.clear(), parameter_.clear();
    status_ = component_.create(&host_, &config, &object_);
    return status_ == WEND_OK;
  }
  void destroy() {
    if (object_) component_.destroy(object_);
    object_ = nullptr;
  }

  // ---- what it said
  wend_status status() const noexcept { return status_; }  // of the last call
  const std::string& error() const noexcept { return error_; }
  const std::string& parameter() const noexcept { return parameter_; }
  struct Line {
    std::uint32_t level;
    std::string text;
  };
  std::vector<Line> logged;
  std::vector<std::pair<std::string, std::pair<double, double>>> series;  // "x/y" -> point

  // ---- the object
  wend_ref ref() const noexcept { return {object_, &component_}; }
  template <class T>
  T& object() noexcept {  // of a component in this program, never of a loaded one
    return detail::of<T>(object_).value;
  }
  template <class Table>
  const Table* table(const char* id) const {
    return static_cast<const Table*>(component_.query(object_, id));
  }
  std::uint32_t rows() const noexcept { return copies_ * robots_; }
  std::vector<std::uint32_t> all_rows() const {
    std::vector<std::uint32_t> all(rows());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  // ---- calls, on all rows where none are named
  // Row r's seed is that of stream number r below `seed`.
  void begin(std::uint64_t seed, std::uint32_t mode = WEND_TEST) { begin_rows(all_rows(), seed, mode); }
  void begin_rows(const std::vector<std::uint32_t>& rows, std::uint64_t seed, std::uint32_t mode = WEND_TEST) {
    std::vector<wend_episode> episodes;
    for (const std::uint32_t row : rows) episodes.push_back({0, wend::stream(seed, std::uint64_t{row}), 0, 0, mode});
    const auto n = static_cast<std::uint32_t>(rows.size());
    for (const auto call :
         {begin_of<wend_sensor>(WEND_SENSOR), begin_of<wend_policy>(WEND_POLICY), begin_of<wend_reward>(WEND_REWARD)})
      if (call) checked(call(object_, rows.data(), n, episodes.data()));
  }
  std::vector<double> sense() { return sense(all_rows()); }
  std::vector<double> sense(const std::vector<std::uint32_t>& rows) {
    const auto* sensor = needed<wend_sensor>(WEND_SENSOR);
    const std::size_t width = sensor->space(object_)->width;
    std::vector<double> out(rows.size() * width);
    checked(sensor->sense(object_, rows.data(), static_cast<std::uint32_t>(rows.size()), out.data(), width));
    return out;
  }
  std::vector<double> act(const std::vector<double>& observations) { return act(all_rows(), observations); }
  std::vector<double> act(const std::vector<std::uint32_t>& rows, const std::vector<double>& observations) {
    const auto* policy = needed<wend_policy>(WEND_POLICY);
    require(observations.size() == rows.size() * observation_->width, "act: observations are not rows x width");
    std::vector<double> actions(rows.size() * action_->width);
    checked(policy->act(object_, rows.data(), static_cast<std::uint32_t>(rows.size()), observations.data(),
                        actions.data()));
    return actions;
  }
  // One transition of each row; the reward starts from the world's outcomes, as in the host.
  std::vector<wend_outcome> score(const std::vector<double>& observations, const std::vector<double>& actions,
                                  const std::vector<double>& next, const std::vector<wend_outcome>& outcomes) {
    const auto rows = all_rows();
    std::vector<wend_outcome> scored = outcomes;
    const wend_batch batch{sizeof batch,   rows_in(outcomes), rows.data(),    observations.data(),
                           actions.data(), next.data(),       outcomes.data()};
    checked(needed<wend_reward>(WEND_REWARD)->score(object_, &batch, scored.data()));
    return scored;
  }
  std::vector<double> telemetry(std::uint32_t when) {
    const auto* telemetry = needed<wend_telemetry>(WEND_TELEMETRY);
    const wend_space* space = telemetry->space(object_, when);
    if (space == nullptr) return {};
    const auto rows = all_rows();
    const std::uint32_t n = when == WEND_PER_UPDATE ? 1 : this->rows();
    std::vector<double> out(std::size_t{n} * space->width);
    checked(telemetry->read(object_, when, when == WEND_PER_UPDATE ? nullptr : rows.data(), n, out.data()));
    return out;
  }
  std::string explain(std::uint32_t row = 0) {
    std::string text;
    const wend_sink sink = sink_into(text);
    checked(needed<wend_telemetry>(WEND_TELEMETRY)->text(object_, row, &sink));
    return text;
  }
  std::string save() {
    std::string bytes;
    const wend_sink sink = sink_into(bytes);
    checked(needed<wend_state>(WEND_STATE)->save(object_, &sink));
    return bytes;
  }
  void load(const std::string& bytes) {
    checked(needed<wend_state>(WEND_STATE)->load(object_, bytes.data(), bytes.size()));
  }

 private:
  struct Value {
    double number = 0;
    std::string text;
    bool is_text = false;
  };
  using Begin = wend_status (*)(wend_object*, const std::uint32_t*, std::uint32_t, const wend_episode*);

  static Bench& of(const wend_host* host) { return *static_cast<const Host*>(host)->bench; }
  static wend_sink sink_into(std::string& text) {
    return {sizeof(wend_sink), &text, [](void* to, const void* bytes, std::uint64_t n) -> wend_status {
              static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), n);
              return WEND_OK;
            }};
  }
  static std::vector<wend_value> flat(const std::map<std::string, Value>& values) {
    std::vector<wend_value> all;
    for (const auto& [path, value] : values)
      all.push_back({path.c_str(), value.is_text ? value.text.c_str() : nullptr, value.number});
    return all;
  }
  static std::vector<wend_named> named(const std::deque<std::pair<std::string, wend_ref>>& refs) {
    std::vector<wend_named> all;
    for (const auto& [name, ref] : refs) all.push_back({name.c_str(), ref});
    return all;
  }
  std::uint32_t rows_in(const std::vector<wend_outcome>& outcomes) const {
    require(outcomes.size() <= rows(), "score: more outcomes than rows");
    return static_cast<std::uint32_t>(outcomes.size());
  }
  static void require(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
  }
  template <class Table>
  const Table* needed(const char* id) const {
    const auto* found = object_ ? table<Table>(id) : nullptr;
    if (!found) throw std::invalid_argument(std::string(component_.id) + " does not answer for " + id);
    return found;
  }
  template <class Table>
  Begin begin_of(const char* id) const {
    const auto* found = object_ ? table<Table>(id) : nullptr;
    return found ? found->begin : nullptr;
  }
  void checked(wend_status status) {
    status_ = status;
    if (status != WEND_OK) throw std::runtime_error(error_);
  }

  struct Host : wend_host {
    Bench* bench;
  };
  Host host_{{}, this};
  wend_component component_;
  wend_object* object_ = nullptr;
  wend_status status_ = WEND_OK;
  std::string error_, parameter_;
  std::map<std::string, Value> values_, robot_;
  const wend_space *observation_ = nullptr, *action_ = nullptr;
  std::deque<std::pair<std::string, wend_ref>> slots_, uses_;
  std::uint32_t copies_ = 1, robots_ = 1;
  std::uint64_t seed_ = 1;
};

// Text of what `call` throws, or "" if it throws nothing.
template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace wend::testing
