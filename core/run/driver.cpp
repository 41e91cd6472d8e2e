#include <core/run/driver.hpp>
#include <core/run/failure.hpp>
#include <wend/bytes.hpp>

#include <algorithm>
#include <limits>

namespace wend::core {
namespace {

constexpr std::string_view state_magic = "wend state 1";

wend_status append(void* context, const void* bytes, std::uint64_t n) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(bytes), n);
  return WEND_OK;
}

wend_sink sink_of(std::string& text) { return {sizeof(wend_sink), &text, &append}; }

}  // namespace

Driver::Driver(const DriverSpec& spec, const Stage& stage)
    : action_(&stage.action()), bounds_(stage.action()), root_(std::make_unique<Instance>(spec.policy, "policy", stage.surroundings())) {
  policy_ = &root_->need<wend_policy>(WEND_POLICY);
  learner_ = root_->get<wend_learner>(WEND_LEARNER);
}

void Driver::begin(const std::vector<std::uint32_t>& rows, const std::vector<wend_episode>& episodes) {
  if (policy_->begin)
    root_->check(policy_->begin(root_->self(), rows.data(), static_cast<std::uint32_t>(rows.size()), episodes.data()), "begin");
}

void Driver::act(const std::vector<std::uint32_t>& rows, const double* observations, double* actions) {
  const std::size_t all = rows.size() * bounds_.width();
  std::fill_n(actions, all, std::numeric_limits<double>::quiet_NaN());  // a row it forgets is not the last one's action
  root_->check(policy_->act(root_->self(), rows.data(), static_cast<std::uint32_t>(rows.size()), observations, actions), "act");
  const std::size_t bad = bounds_.first_outside(actions, rows.size());
  if (bad == all) return;
  const std::size_t column = bad % bounds_.width();
  throw UnitFailed("rule", root_->path() + " (" + root_->type() + "): act: expected " + bounds_.expected(column) + " for " +
                               action_->columns[column].name + ", found " + as_text(actions[bad]));
}

std::uint64_t Driver::learn(const wend_batch& batch) {
  std::uint64_t used = 0;
  root_->check(learner_->learn(root_->self(), &batch, &used), "learn");
  if (used > batch.n)
    throw UnitFailed("rule", root_->path() + " (" + root_->type() + "): learn: expected at most the batch's " +
                                 std::to_string(batch.n) + " samples to be used, found " + std::to_string(used));
  return used;
}

void Driver::finish() {
  if (learner_ && learner_->finish) root_->check(learner_->finish(root_->self()), "finish");
}

std::string Driver::save() const {
  std::string all;
  wend_sink sink = sink_of(all);
  Writer writer(&sink);
  writer.put(state_magic);
  root_->visit([&](Instance& instance) {
    const auto* table = instance.get<wend_state>(WEND_STATE);
    if (table == nullptr) return;
    std::string bytes;
    const wend_sink own = sink_of(bytes);
    instance.check(table->save(instance.self(), &own), "save");
    writer.put(std::string_view(instance.path()));
    writer.put(std::string_view(instance.type()));
    writer.put(std::string_view(bytes));
  });
  return all;
}

void Driver::load(const std::string& bytes, const std::string& name) {
  try {
    Reader reader(bytes.data(), bytes.size());
    reader.expect(state_magic);
    root_->visit([&](Instance& instance) {
      const auto* table = instance.get<wend_state>(WEND_STATE);
      if (table == nullptr) return;
      const std::string path = reader.get_text(), type = reader.get_text(), own = reader.get_text();
      if (path != instance.path() || type != instance.type())
        throw UnitFailed("state", name + ": expected the state of " + instance.type() + " at " + instance.path() + ", found that of " +
                                      type.substr(0, 60) + " at " + path.substr(0, 60));
      const wend_status status = table->load(instance.self(), own.data(), own.size());
      if (status != WEND_OK) throw UnitFailed("state", name + ": " + instance.why(status, "load"));
    });
    reader.end();
  } catch (const wend::Error& damaged) {
    throw UnitFailed("state", name + ": " + damaged.what());
  }
}

}  // namespace wend::core
