#include <core/run/failure.hpp>
#include <core/run/instance.hpp>
#include <core/run/values.hpp>
#include <wend/random.hpp>

#include <mutex>

namespace wend::core {
namespace {

std::mutex telling;  // plugins may log and fail from threads of their own

}  // namespace

// The wend_host of one object, with what it was told last.
struct Instance::Host {
  wend_host table{};  // first: the plugin's pointer to it is a pointer to this
  const Listener* listener = nullptr;
  std::string path, message, parameter;
  FlatValues params, robot;  // valid until destroy(), so that a plugin may keep pointers into its configuration

  static Host& of(const wend_host* host) { return *const_cast<Host*>(reinterpret_cast<const Host*>(host)); }

  static wend_status fail(const wend_host* host, wend_status code, const char* param, const char* message) {
    const std::lock_guard lock(telling);
    of(host).message = message ? message : "";
    of(host).parameter = param ? param : "";
    return code == WEND_OK ? WEND_E_INTERNAL : code;
  }
  static void log(const wend_host* host, std::uint32_t level, const char* message) {
    const Host& self = of(host);
    const std::lock_guard lock(telling);
    if (self.listener && self.listener->log) self.listener->log(level, self.path + ": " + (message ? message : ""));
  }
  static void random(const wend_host*, std::uint64_t key, std::uint64_t counter, double* out, std::uint64_t n) {
    wend::uniform(key, counter, out, n);
  }
  static std::uint64_t stream(const wend_host*, std::uint64_t parent, const char* name) {
    return wend::stream(parent, std::string_view(name ? name : ""));
  }
  static void series(const wend_host* host, const char* x_name, double x, const char* y_name, double y) {
    const Host& self = of(host);
    const std::lock_guard lock(telling);
    if (self.listener && self.listener->series) self.listener->series(self.path, x_name, x, y_name, y);
  }
  static const void* extension(const wend_host*, const char*) { return nullptr; }
};

Instance::Instance(const ComponentSpec& spec, std::string path, const Surroundings& around)
    : path_(std::move(path)), type_(spec.type), host_(std::make_unique<Host>()) {
  std::vector<std::string> names;
  for (const auto& [name, slot] : spec.slots) {
    slots_.push_back(std::make_unique<Instance>(slot, path_ + "/" + name, around));
    names.push_back(name);
  }
  std::vector<wend_named> slots;
  for (std::size_t i = 0; i < slots_.size(); ++i) slots.push_back({names[i].c_str(), slots_[i]->ref()});
  const wend_named world{"world", around.world};

  host_->table = {sizeof(wend_host), &Host::fail, &Host::log, &Host::random, &Host::stream, &Host::series, &Host::extension};
  host_->listener = around.listener;
  host_->path = path_;
  host_->params = FlatValues(spec.params);
  if (around.robot) host_->robot = FlatValues(*around.robot);

  wend_config config{};
  config.size = sizeof config;
  config.copies = around.copies;
  config.robots = around.robots;
  config.values = host_->params.data();
  config.value_count = host_->params.size();
  config.params = host_->params.text();
  config.robot_values = around.robot ? host_->robot.data() : nullptr;
  config.robot_value_count = around.robot ? host_->robot.size() : 0;
  config.robot = around.robot ? host_->robot.text() : nullptr;
  config.slots = slots.data();
  config.slot_count = static_cast<std::uint32_t>(slots.size());
  config.uses = &world;
  config.use_count = around.world.self ? 1 : 0;
  config.seed = around.key ? around.key(path_) : 0;
  config.observation = around.observation;
  config.action = around.action;

  component_ = &around.libraries->component(spec.type);
  check(component_->create(&host_->table, &config, &self_), "create");
  if (self_ == nullptr) throw UnitFailed("rule", path_ + " (" + type_ + "): create returned WEND_OK and no object");
}

Instance::~Instance() {
  if (self_) component_->destroy(self_);
}

const void* Instance::query(const char* id) const { return component_->query(self_, id); }

void Instance::missing(const char* id) const {
  throw UnitFailed("rule", path_ + " (" + type_ + "): expected the interface " + id + ", which its manifest names; query() found none");
}

// A slot that failed inside a call of its owner told its own host; that message is the nearer one.
const Instance* Instance::speaker() const {
  if (!host_->message.empty()) return this;
  for (const auto& slot : slots_)
    if (const Instance* below = slot->speaker()) return below;
  return nullptr;
}

std::string Instance::why(wend_status status, const char* call) const {
  static constexpr const char* kinds[] = {"ok", "argument", "parameter", "unsupported", "state", "internal"};
  const std::lock_guard lock(telling);
  const Instance* found = speaker();
  const Instance& origin = found ? *found : *this;
  const std::string kind = status > 0 && status < 6 ? kinds[status] : "status " + std::to_string(status);
  const std::string& parameter = origin.host_->parameter;
  return origin.path_ + " (" + origin.type_ + "): " + call + ": " + kind + " error: " + (parameter.empty() ? "" : parameter + ": ") +
         (found ? origin.host_->message : "it gave no message");
}

void Instance::failed(wend_status status, const char* call) const { throw UnitFailed("plugin", why(status, call)); }

void Instance::visit(const std::function<void(Instance&)>& visitor) {
  for (const auto& slot : slots_) slot->visit(visitor);
  visitor(*this);
}

}  // namespace wend::core
