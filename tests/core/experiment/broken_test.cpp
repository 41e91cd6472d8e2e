#include <gtest/gtest.h>

#include <core/experiment/pointer.hpp>
#include <sstream>
#include <tests/core/experiment/fixture.hpp>

namespace wend::core {
namespace {

struct Broken {
  std::string title, changes, expected;
};

// Blocks of "== title", changes, "--" and what is said.
void read_blocks(const std::string& path, std::vector<Broken>& all) {
  const std::size_t before = all.size();
  std::ifstream file(path);
  bool expected = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("== ")) {
      all.push_back({line.substr(3), "", ""});
      expected = false;
    } else if (line == "--") {
      expected = true;
    } else if (all.size() > before && !line.empty()) {
      (expected ? all.back().expected : all.back().changes) += line + "\n";
    }
  }
}

std::vector<Broken> broken_experiments() {
  std::vector<Broken> all;
  for (const char* name : {"composition", "plan"})
    read_blocks(WEND_SOURCE_DIR "/tests/core/experiment/broken/" + std::string(name) + ".txt", all);
  return all;
}

Json changed(Json experiment, const std::string& changes) {
  std::istringstream lines(changes);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("-")) {
      const Json::json_pointer pointer(line.substr(1));
      experiment[pointer.parent_pointer()].erase(pointer.back());
    } else {
      const std::size_t space = line.find(' ');
      EXPECT_EQ(assign(experiment, line.substr(0, space), Json::parse(line.substr(space + 1))), std::nullopt);
    }
  }
  return experiment;
}

class BrokenExperiment : public ExperimentFolder {};

TEST_F(BrokenExperiment, IsExplainedWordForWord) {
  const std::vector<Broken> all = broken_experiments();
  EXPECT_GE(all.size(), 50u);
  for (const Broken& broken : all) {
    EXPECT_FALSE(load(changed(small_experiment(), broken.changes))) << broken.title;
    EXPECT_EQ(complaints_, broken.expected) << broken.title;
  }
}

TEST_F(BrokenExperiment, EachBreaksAnotherRule) {
  std::set<std::string> titles;
  for (const Broken& broken : broken_experiments()) EXPECT_TRUE(titles.insert(broken.title).second) << broken.title;
}

TEST_F(BrokenExperiment, TheExperimentThatTheyBreakIsWhole) {
  EXPECT_TRUE(load(small_experiment()));
  EXPECT_EQ(complaints_, "");
}

}  // namespace
}  // namespace wend::core
