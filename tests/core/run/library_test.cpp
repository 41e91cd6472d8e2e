#include <cfenv>
#include <core/run/library.hpp>

#include "fixture.hpp"

namespace wend::core {
namespace {

constexpr const char* bad_folder = WEND_TEST_PLUGINS "/bad/";

class Library : public RunTest {
 protected:
  std::string failure_of(const std::string& file, const std::string& id = "some.id") {
    libraries_.know({{id, file}});
    return failure([&] { libraries_.component(id); });
  }
};

TEST_F(Library, FindsTheComponentById) {
  const wend_component& script = libraries_.component("test.script");
  EXPECT_STREQ(script.id, "test.script");
  EXPECT_EQ(&libraries_.component("test.script"), &script);
  EXPECT_NE(&libraries_.component("test.table"), &script);
}

TEST_F(Library, SaysWhatIsWrongWithAFile) {
  EXPECT_EQ(failure([&] { libraries_.component("no.such"); }),
            "load: no plugin file is known for component \"no.such\"");
  const std::string folder = bad_folder;
  EXPECT_EQ(failure_of(folder + "no_symbol.so"),
            "load: " + folder + "no_symbol.so: expected the exported symbol wend_plugin_1, found none");
  EXPECT_EQ(failure_of(folder + "wrong_abi.so"),
            "load: " + folder + "wrong_abi.so: expected ABI 1.x, found 2.7; build it against this wend's headers");
  const std::string counting = WEND_TEST_PLUGINS "/wend-test-counting.so";
  EXPECT_EQ(failure_of(counting, "test.absent"),
            "load: " + counting + ": its manifest names component \"test.absent\", its code does not");
  EXPECT_NE(failure_of(folder + "unresolved.so").find("undefined symbol: nobody_has_this"), std::string::npos);
  EXPECT_EQ(failure_of(folder + "missing.so").find("load: cannot load " + folder + "missing.so: "), 0u);
}

TEST_F(Library, AFileThatFailedIsTriedAgain) {
  EXPECT_NE(failure_of(folder_ + "/late.so"), "nothing");
  std::filesystem::copy_file(WEND_TEST_PLUGINS "/wend-test-counting.so", folder_ + "/late.so");
  EXPECT_EQ(failure_of(folder_ + "/late.so", "test.script"), "nothing");
}

TEST_F(Library, LoadingKeepsTheFloatingPointEnvironment) {
  failure_of(std::string(bad_folder) + "fast_math.so");
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  volatile double tiny = 5e-324;
  EXPECT_GT(tiny * 1.0, 0);  // not flushed to zero
}

}  // namespace
}  // namespace wend::core
