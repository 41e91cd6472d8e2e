// wend installed to a temporary prefix, and plugins built against that with nothing of this tree.
#pragma once
#include <optional>

#include "support/wend.hpp"

namespace wend::test {

class Installed {
 public:
  Installed();

  std::string operator/(const std::string& name) const { return place_ / ("prefix/" + name); }
  std::string program() const { return *this / "bin/wend"; }
  const TemporaryDirectory& place() const { return place_; }

  // Builds `source` with CMake and find_package(wend) and returns the folder of the plugin.
  std::string build(const std::string& source, const std::vector<std::string>& options = {}) const;
  // Copies an example with another component id, so that two builds of it fit into one experiment.
  std::string renamed(const std::string& example, const std::string& from, const std::string& to) const;

  std::optional<std::string> build_with_libcxx(const std::string& source) const;  // nothing: clang or libc++ is missing
  std::optional<std::string> build_rust(const std::string& source) const;         // nothing: rustc is missing

 private:
  TemporaryDirectory place_;
};

}  // namespace wend::test
