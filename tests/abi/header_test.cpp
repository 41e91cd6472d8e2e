// Today's abi.h keeps every promise of 1.0: nothing moved, removed or retyped; it compiles everywhere and pulls in
// little.
#include "header.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <regex>
#include <sstream>

#include "support/wend.hpp"

using namespace wend::test;

namespace {

const std::string old_header = WEND_SOURCE_DIR "/tests/abi/abi_1_0.h",
                  new_header = WEND_SOURCE_DIR "/sdk/include/wend/abi.h";
const std::string include = "-I" WEND_SOURCE_DIR "/sdk/include";

std::string output_of(const TemporaryDirectory& place, const Header& header, const std::string& path) {
  const std::string source = place.write("layout.c", layout_program(header, path));
  const Outcome built = run({WEND_C_COMPILER, "-std=c11", "-Wno-invalid-offsetof", source, "-o", place / "layout"});
  EXPECT_EQ(built.exit, 0) << built.err;
  return run({place / "layout"}).out;
}

long preprocessed_lines(const TemporaryDirectory& place, const std::vector<std::string>& compiler,
                        const std::string& header, const std::string& file) {
  std::vector<std::string> command = compiler;
  command.insert(command.end(), {include, "-E", "-P", place.write(file, "#include <wend/" + header + ">\n")});
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  std::istringstream text(outcome.out);
  long lines = 0;
  for (std::string line; std::getline(text, line);) lines += line.find_first_not_of(" \t") != std::string::npos;
  return lines;
}

}  // namespace

TEST(Header, IsReadWhole) {
  const Header header = read_header(old_header);
  std::map<std::string, std::size_t> members;
  for (const Struct& one : header.structs) members[one.name] = one.members.size();
  EXPECT_EQ(header.structs.size(), 29u);
  EXPECT_EQ(members["wend_host"], 7u);
  EXPECT_EQ(members["wend_column"], 6u);
  EXPECT_EQ(members["wend_config"], 16u);
  EXPECT_EQ(members["wend_limits"], 8u);
  EXPECT_EQ(members["wend_shape"], 8u);
  EXPECT_EQ(members["wend_plugin"], 5u);
  EXPECT_EQ(header.constants.size(), 27u);
  EXPECT_EQ(header.texts.size(), 11u);
}

TEST(Header, NothingMovedSince1_0) {
  const TemporaryDirectory place;
  const Header header = read_header(old_header);
  const std::string then = output_of(place, header, old_header), now = output_of(place, header, new_header);
  EXPECT_EQ(then, now);
  EXPECT_GT(then.size(), 1000u);
}

TEST(Header, MembersAreOnlyAppended) {
  const Header then = read_header(old_header), now = read_header(new_header);
  std::map<std::string, Struct> today;
  for (const Struct& one : now.structs) today[one.name] = one;
  for (const Struct& one : then.structs) {
    ASSERT_TRUE(today.count(one.name)) << one.name << " is gone";
    const Struct& other = today[one.name];
    EXPECT_EQ(one.frozen, other.frozen) << one.name;
    ASSERT_GE(other.members.size(), one.members.size()) << one.name;
    if (one.frozen) {
      EXPECT_EQ(other.members.size(), one.members.size()) << one.name << " is FROZEN";
    }
    for (std::size_t i = 0; i < one.members.size(); ++i) EXPECT_EQ(other.members[i], one.members[i]) << one.name;
  }
}

// A table that may grow says first how large it is; one that does not is FROZEN.
TEST(Header, TablesAreSizedOrFrozen) {
  for (const Struct& one : read_header(new_header).structs)
    EXPECT_NE(one.frozen, one.members[0].second == "uint32_t size") << one.name << ": " << one.members[0].second;
}

TEST(Header, CompilesAsCAndCpp) {
  const TemporaryDirectory place;
  const std::string c = place.write("probe.c",
                                    "#include <wend/abi.h>\nwend_status s(const wend_host *h) { return WEND_HAS(h, "
                                    "extension) ? WEND_OK : WEND_E_INTERNAL; }\n");
  const std::string cpp = place.write("probe.cpp", read_text(c));
  int compilers = 0;
  for (const std::string& name : {std::string(WEND_C_COMPILER), find_program({"gcc"}), find_program({"clang"})}) {
    if (name.empty()) continue;
    ++compilers;
    const Outcome as_c = run({name, "-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Wno-language-extension-token",
                              "-Werror", include, "-c", c, "-o", place / "c.o"});
    EXPECT_EQ(as_c.exit, 0) << name << "\n" << as_c.err;
    const Outcome as_cpp = run(
        {name, "-x", "c++", "-std=c++20", "-Wall", "-Wextra", "-Werror", include, "-c", cpp, "-o", place / "cpp.o"});
    EXPECT_EQ(as_cpp.exit, 0) << name << "\n" << as_cpp.err;
  }
  EXPECT_GE(compilers, 2);
}

TEST(Header, IncludesTwoHeadersOnly) {
  const std::string text = read_text(new_header);
  const std::regex include_line("#\\s*include\\s*(\\S+)");
  std::vector<std::string> included;
  for (std::sregex_iterator at(text.begin(), text.end(), include_line), end; at != end; ++at)
    included.push_back((*at)[1]);
  EXPECT_EQ(included, (std::vector<std::string>{"<stddef.h>", "<stdint.h>"}));
}

// What a plugin's author compiles each time.  <string>, <vector> and <span> alone are 23,400 lines with g++ 12.
TEST(Header, PullsInLittle) {
  const TemporaryDirectory place;
  const long c = preprocessed_lines(place, {WEND_C_COMPILER, "-std=c11"}, "abi.h", "abi.c");
  const long cpp = preprocessed_lines(place, {WEND_CXX_COMPILER, "-std=c++20"}, "plugin.hpp", "plugin.cpp");
  std::cout << "preprocessed: abi.h " << c << " lines of C, plugin.hpp " << cpp << " lines of C++\n";
  EXPECT_LT(c, 1000);
  EXPECT_LT(cpp, 30000);
}
