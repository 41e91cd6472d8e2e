#include "installed.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace wend::test {

namespace fs = std::filesystem;

Installed::Installed() {
  const Outcome outcome = run({WEND_CMAKE, "--install", WEND_BINARY_DIR, "--prefix", place_ / "prefix"});
  if (outcome.exit != 0) throw std::runtime_error("cmake --install failed: " + outcome.err);
}

std::string Installed::build(const std::string& source, const std::vector<std::string>& options) const {
  const std::string folder = source + "/build";
  std::vector<std::string> configure = {
      WEND_CMAKE, "-S", source, "-B", folder, "-DCMAKE_PREFIX_PATH=" + (*this / ""), "-DCMAKE_BUILD_TYPE=Debug"};
  configure.insert(configure.end(), options.begin(), options.end());
  for (const Outcome& outcome : {run(configure), run({WEND_CMAKE, "--build", folder})})
    EXPECT_EQ(outcome.exit, 0) << source << "\n" << outcome.out << outcome.err;
  return folder;
}

std::string Installed::renamed(const std::string& example, const std::string& from, const std::string& to) const {
  const std::string folder = place_ / ("renamed_" + to);
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(*this / ("share/wend/examples/" + example)))
    if (entry.is_regular_file())
      place_.write("renamed_" + to + "/" + entry.path().filename().string(),
                   replaced(read_text(entry.path()), from, to));
  return folder;
}

std::optional<std::string> Installed::build_with_libcxx(const std::string& source) const {
  const std::string clang = find_program({"clang++", "clang++-14"});
  if (clang.empty()) return std::nullopt;
  const std::string probe =
      place_.write("probe.cpp", "#include <string>\nint main() { return std::string().size(); }\n");
  if (run({clang, "-stdlib=libc++", probe, "-o", place_ / "probe"}).exit != 0) return std::nullopt;
  return build(source, {"-DCMAKE_CXX_COMPILER=" + clang, "-DCMAKE_CXX_FLAGS=-stdlib=libc++"});
}

std::optional<std::string> Installed::build_rust(const std::string& source) const {
  const std::string rustc = find_program({"/usr/bin/rustc", "rustc"});  // Debian's, the oldest that has to do
  if (rustc.empty()) return std::nullopt;
  const std::string folder = place_ / "rust";
  fs::create_directories(folder);
  const Outcome outcome =
      run({rustc, "-O", "--crate-type", "cdylib", source + "/turn_to_goal.rs", "-o", folder + "/turn-to-goal-rust.so"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  return folder;
}

}  // namespace wend::test
