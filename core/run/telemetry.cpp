#include <core/run/telemetry.hpp>

#include <algorithm>
#include <limits>

namespace wend::core {

Telemetry::Telemetry(std::uint32_t when, const Stage* stage, const Driver* driver) : when_(when) {
  if (stage) add(stage->world(), "");
  if (driver)
    driver->root().visit([&](Instance& instance) {
      const std::string path = instance.path();  // "policy", "policy/avoid/..."
      std::string prefix = path.size() > 7 ? path.substr(7) + "." : "";
      std::replace(prefix.begin(), prefix.end(), '/', '.');
      add(instance, prefix);
    });
}

void Telemetry::add(const Instance& instance, const std::string& prefix) {
  const auto* table = instance.get<wend_telemetry>(WEND_TELEMETRY);
  const wend_space* space = table ? table->space(instance.self(), when_) : nullptr;
  if (space == nullptr || space->width == 0) return;
  sources_.push_back({&instance, table, names_.size(), space->width});
  for (std::uint32_t i = 0; i < space->width; ++i) {
    std::string name = prefix + space->columns[i].name;
    while (std::find(names_.begin(), names_.end(), name) != names_.end()) name = "policy." + name;
    names_.push_back(name);
  }
}

std::vector<double> Telemetry::gather(const std::uint32_t* rows, std::uint32_t n) const {
  std::vector<double> all(n * names_.size()), own;
  for (const Source& source : sources_) {
    own.assign(n * source.width, std::numeric_limits<double>::quiet_NaN());
    source.instance->check(source.table->read(source.instance->self(), when_, rows, n, own.data()), "telemetry");
    for (std::uint32_t i = 0; i < n; ++i)
      std::copy_n(own.begin() + static_cast<std::ptrdiff_t>(i * source.width), source.width,
                  all.begin() + static_cast<std::ptrdiff_t>(i * names_.size() + source.offset));
  }
  return all;
}

std::vector<double> Telemetry::read(const std::vector<std::uint32_t>& rows) const {
  return gather(rows.data(), static_cast<std::uint32_t>(rows.size()));
}

std::vector<double> Telemetry::read() const { return gather(nullptr, 1); }

}  // namespace wend::core
