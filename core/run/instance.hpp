// One component with what stands in its slots: created, called and destroyed, every error turned into UnitFailed.
#pragma once
#include <core/experiment/unit.hpp>
#include <core/run/library.hpp>
#include <wend/abi.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wend::core {

// What the host listens to while plugins run.
struct Listener {
  std::function<void(std::uint32_t level, const std::string& message)> log;
  std::function<void(const std::string& path, const char* x_name, double x, const char* y_name, double y)> series;
};

// What every instance of a composition is created with.
struct Surroundings {
  Libraries* libraries = nullptr;
  const Listener* listener = nullptr;
  std::uint32_t copies = 1, robots = 1;
  std::function<std::uint64_t(const std::string& path)> key;  // config.seed of the component at `path`
  wend_ref world{nullptr, nullptr};                           // lent as "world"
  const wend_space* observation = nullptr;
  const wend_space* action = nullptr;
  const Json* robot = nullptr;                                // the definition, for worlds
};

class Instance {
 public:
  // `path` names the component in messages, keys and telemetry: "policy", "policy/avoid", "sensor/sonar".
  Instance(const ComponentSpec& spec, std::string path, const Surroundings& surroundings);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  wend_ref ref() const noexcept { return {self_, component_}; }
  wend_object* self() const noexcept { return self_; }
  const std::string& path() const noexcept { return path_; }
  const std::string& type() const noexcept { return type_; }
  const std::vector<std::unique_ptr<Instance>>& slots() const noexcept { return slots_; }

  // The table of an interface, or nullptr.  `need` throws where it is not there.
  template <class Table>
  const Table* get(const char* id) const {
    return static_cast<const Table*>(query(id));
  }
  template <class Table>
  const Table& need(const char* id) const {
    const Table* table = get<Table>(id);
    if (table == nullptr) missing(id);
    return *table;
  }

  // Throws UnitFailed("plugin") with the plugin's own message where status is not WEND_OK.
  void check(wend_status status, const char* call) const {
    if (status != WEND_OK) failed(status, call);
  }

  // What the plugin said when a call of it gave this status.
  std::string why(wend_status status, const char* call) const;

  // This one and all below it, owners after their slots.
  void visit(const std::function<void(Instance&)>& visitor);

 private:
  struct Host;
  const void* query(const char* id) const;
  const Instance* speaker() const;
  [[noreturn]] void missing(const char* id) const;
  [[noreturn]] void failed(wend_status status, const char* call) const;

  std::string path_, type_;
  std::vector<std::unique_ptr<Instance>> slots_;
  std::unique_ptr<Host> host_;
  const wend_component* component_ = nullptr;
  wend_object* self_ = nullptr;
};

}  // namespace wend::core
