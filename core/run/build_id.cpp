#include <core/base/sha256.hpp>
#include <core/run/build_id.hpp>

#include <unistd.h>

#include <ctime>
#include <fstream>

namespace wend::core {
namespace {

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

Json build_description(const std::map<std::string, std::string>& plugins, const std::string& worker) {
  Json hashes = Json::object();
  for (const auto& [id, file] : plugins) hashes[id] = sha256_of_file(file);
  return {{"version", version}, {"worker", sha256_of_file(worker)}, {"compiler", __VERSION__}, {"flags", WEND_BUILD_FLAGS}, {"isa", "x86-64"}, {"plugins", hashes}};
}

Json session_description(const std::string& command) {
  char host[256] = "unknown", started[32] = "";
  gethostname(host, sizeof host - 1);
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::strftime(started, sizeof started, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {{"command", command}, {"started", started}, {"host", host}, {"cpu", cpu_name()}};
}

}  // namespace wend::core
