#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <core/base/files.hpp>
#include <core/plugin/catalog.hpp>
#include <ctime>

#include "plugin_files.hpp"

namespace wend::core {
namespace {

class Catalogs : public PluginFiles {
 protected:
  std::string plugin(const std::string& name, const std::string& id) const {
    return put(name, PluginImage(manifest_of(id)));
  }
  static std::string listed(const Catalog& catalog) {
    std::string all;
    for (const std::string& id : catalog.ids()) all += id + " ";
    return all;
  }
};

TEST_F(Catalogs, FindsComponentsSortedAndByInterface) {
  plugin("b.so", "x.second");
  plugin("a.so", "x.first");
  put("w.so", PluginImage(R"({"wend": 1, "name": "w", "version": "1", "components": [)"
                          R"({"id": "x.world", "summary": "s", "interfaces": ["wend.world/1", "wend.sensor/1"]}]})"));
  put("readme.txt", "not a plugin, and not looked at");
  const Catalog catalog = Catalog::search({directory_});
  ASSERT_EQ(catalog.files().size(), 3u);
  EXPECT_EQ(catalog.files()[0].path, path("a.so"));
  EXPECT_EQ(catalog.files()[0].manifest->file, path("a.so"));
  EXPECT_EQ(listed(catalog), "x.first x.second x.world ");
  EXPECT_EQ(catalog.ids("wend.sensor/1"), std::vector<std::string>{"x.world"});
  EXPECT_EQ(catalog.file_of("x.second"), path("b.so"));
  EXPECT_EQ(catalog.find("x.second")->summary, "A test.");
  EXPECT_EQ(catalog.find("x.third"), nullptr);
  EXPECT_EQ(catalog.file_of("x.third"), "");
  EXPECT_EQ(catalog.problem("x.third"), std::nullopt);
}

TEST_F(Catalogs, UnusableFilesAreExplainedAndStopNothing) {
  plugin("good.so", "x.good");
  put("broken.so", "text");
  put("json.so", PluginImage("{\"wend\": 1,}"));
  put("empty.so", "");
  std::filesystem::create_directory(path("folder.so"));
  std::filesystem::create_symlink("nowhere", path("link.so"));
  ASSERT_EQ(::mkfifo(path("pipe.so").c_str(), 0600), 0);
  const Catalog catalog = Catalog::search({path("missing"), directory_});
  EXPECT_EQ(listed(catalog), "x.good ");
  std::vector<std::pair<std::string, std::string>> told;
  for (const PluginFile& file : catalog.files()) told.emplace_back(file.path, file.problem);
  const std::vector<std::pair<std::string, std::string>> expected{
      {path("missing"), "no such file or directory"},
      {path("broken.so"), "not an ELF file, expected a shared object"},
      {path("empty.so"), "an empty file, expected a shared object"},
      {path("folder.so"), "a directory, expected a shared object"},
      {path("good.so"), ""},
      {path("json.so"),
       "error: expected a key in double quotes, found \"}\"\n  --> " + path("json.so") +
           " (.wend.manifest):1:12\n   1 |  {\"wend\": 1,}\n     |             ^ remove the comma before it"},
      {path("link.so"), "cannot be opened: No such file or directory"},
      {path("pipe.so"), "not a regular file"}};
  EXPECT_EQ(told, expected);
}

TEST_F(Catalogs, AnIdTwiceInOneDirectoryIsAnErrorThatNamesBothFiles) {
  plugin("a.so", "x.same");
  plugin("b.so", "x.same");
  plugin("c.so", "x.other");
  const Catalog catalog = Catalog::search({directory_});
  const std::string problem = "component \"x.same\" is in two plugins of one directory: " + path("a.so") + " and " +
                              path("b.so") + "; remove one of them";
  EXPECT_EQ(catalog.problem("x.same"), problem);
  EXPECT_EQ(catalog.find("x.same"), nullptr);
  EXPECT_EQ(catalog.file_of("x.same"), "");
  EXPECT_EQ(catalog.files()[0].problem, problem);
  EXPECT_EQ(catalog.files()[1].problem, problem);
  EXPECT_EQ(listed(catalog), "x.other ");
}

TEST_F(Catalogs, AnEarlierDirectoryShadowsALaterOne) {
  plugin("one/a.so", "x.a");
  plugin("two/a.so", "x.a");
  plugin("two/b.so", "x.b");
  const Catalog catalog = Catalog::search({path("one"), path("two")});
  ASSERT_EQ(catalog.files().size(), 3u);
  EXPECT_EQ(catalog.file_of("x.a"), path("one/a.so"));
  EXPECT_FALSE(catalog.files()[0].shadowed);
  EXPECT_TRUE(catalog.files()[1].shadowed);
  EXPECT_EQ(catalog.files()[1].shadowed_by, path("one/a.so"));
  EXPECT_EQ(catalog.files()[1].problem, "");
  EXPECT_FALSE(catalog.files()[2].shadowed);
  EXPECT_EQ(Catalog::search({path("two"), path("one")}).file_of("x.a"), path("two/a.so"));
}

TEST_F(Catalogs, APartlyShadowedFileIsStillUsed) {
  plugin("one/a.so", "x.a");
  put("two/both.so", PluginImage(R"({"wend": 1, "name": "w", "version": "1", "components": [)"
                                 R"({"id": "x.a", "summary": "s", "interfaces": ["wend.policy/1"]},)"
                                 R"({"id": "x.b", "summary": "s", "interfaces": ["wend.policy/1"]}]})"));
  const Catalog catalog = Catalog::search({path("one"), path("two")});
  EXPECT_EQ(catalog.file_of("x.a"), path("one/a.so"));
  EXPECT_EQ(catalog.file_of("x.b"), path("two/both.so"));
  EXPECT_FALSE(catalog.files()[1].shadowed);
  EXPECT_EQ(catalog.files()[1].shadowed_by, path("one/a.so"));
}

TEST_F(Catalogs, TheSameFileOrDirectoryTwiceCountsOnce) {
  plugin("d/a.so", "x.a");
  std::filesystem::create_symlink("a.so", path("d/b.so"));
  std::filesystem::create_directory_symlink("d", path("e"));
  const Catalog catalog = Catalog::search({path("d/a.so"), path("d"), path("e"), path("d/../d/")});
  ASSERT_EQ(catalog.files().size(), 1u);
  EXPECT_EQ(catalog.file_of("x.a"), path("d/a.so"));
  EXPECT_EQ(catalog.problem("x.a"), std::nullopt);
}

TEST_F(Catalogs, AHundredPluginsAreQuick) {
  for (int i = 0; i < 100; ++i) plugin("p" + std::to_string(i) + ".so", "x.p" + std::to_string(i));
  const std::clock_t begin = std::clock();
  const Catalog catalog = Catalog::search({directory_});
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_EQ(catalog.ids().size(), 100u);
  RecordProperty("milliseconds", std::to_string(1000 * seconds));
  EXPECT_LT(seconds, 0.5);  // about 5 ms
}

class SearchPath : public Catalogs {
 protected:
  SearchPath() {
    ::setenv("XDG_DATA_HOME", path("data").c_str(), 1);
    ::setenv("HOME", path("home").c_str(), 1);
    ::unsetenv("WEND_PLUGIN_PATH");
    own_ = std::filesystem::path(program_directory() + "/../lib/wend/plugins").lexically_normal().string();
  }
  // What the build tree adds, if it has its plugins already.
  std::vector<std::string> with_own(std::vector<std::string> all) const {
    if (std::filesystem::exists(own_)) all.push_back(own_);
    return all;
  }
  std::string own_;
};

TEST_F(SearchPath, CommandLineThenEnvironmentThenUserThenProgram) {
  std::filesystem::create_directories(path("data/wend/plugins"));
  ::setenv("WEND_PLUGIN_PATH", (path("v1") + "::" + path("v2") + ":").c_str(), 1);
  EXPECT_EQ(search_path({path("c1") + "/", path("c2.so")}),
            with_own({path("c1"), path("c2.so"), path("v1"), path("v2"), path("data/wend/plugins")}));
}

TEST_F(SearchPath, StandardPlacesThatDoNotExistAreLeftOut) {
  EXPECT_EQ(search_path({}), with_own({}));
}

TEST_F(SearchPath, TheUsersDirectoryWithoutXdg) {
  std::filesystem::create_directories(path("home/.local/share/wend/plugins"));
  for (const char* data : {"", "relative"}) {
    ::setenv("XDG_DATA_HOME", data, 1);
    EXPECT_EQ(search_path({}), with_own({path("home/.local/share/wend/plugins")}));
  }
}

TEST_F(SearchPath, RelativeEntriesBecomeAbsolute) {
  EXPECT_EQ(search_path({"some/../plugins"}), with_own({(std::filesystem::current_path() / "plugins").string()}));
}

}  // namespace
}  // namespace wend::core
