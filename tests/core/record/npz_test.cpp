#include <gtest/gtest.h>

#include <cmath>
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/record/npz.hpp>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>

namespace wend::core {
namespace {

struct Folder {
  std::string path = [] {
    char name[] = "/tmp/wend-npz-XXXXXX";
    return std::string(mkdtemp(name));
  }();
  ~Folder() { std::filesystem::remove_all(path); }
};

NpzWriter sample() {
  NpzWriter file;
  file.add("pose", std::vector<double>{1.5, -2, 1e300, 0, std::numeric_limits<double>::infinity(), 6}, {2, 3});
  file.add("single", std::vector<float>{0.25f}, {1});
  file.add("flags", std::vector<std::uint32_t>{1, 4294967295u}, {2});
  file.add("cells", std::vector<std::uint8_t>{0, 1, 255}, {1, 3, 1});
  file.add("index", std::vector<std::int64_t>{-1, std::numeric_limits<std::int64_t>::max()}, {2});
  file.add("none", std::vector<double>{}, {0, 4});
  file.add_text("about", "{\"arm\": \"é τ\"}");
  return file;
}

std::string reason(std::string_view bytes) {
  try {
    NpzReader(bytes, "x.npz");
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::data);
    return error.what();
  }
  return "";
}

TEST(Npz, GivesBackWhatWasWritten) {
  const std::string bytes = sample().bytes();
  const NpzReader file(bytes, "x.npz");
  Shape shape;
  EXPECT_EQ(file.float64("pose", 2, &shape),
            (std::vector<double>{1.5, -2, 1e300, 0, std::numeric_limits<double>::infinity(), 6}));
  EXPECT_EQ(shape, (Shape{2, 3}));
  EXPECT_EQ(file.float32("single", 1), std::vector<float>{0.25f});
  EXPECT_EQ(file.uint32("flags", 1), (std::vector<std::uint32_t>{1, 4294967295u}));
  EXPECT_EQ(file.uint8("cells", 3, &shape), (std::vector<std::uint8_t>{0, 1, 255}));
  EXPECT_EQ(shape, (Shape{1, 3, 1}));
  EXPECT_EQ(file.int64("index", 1), (std::vector<std::int64_t>{-1, std::numeric_limits<std::int64_t>::max()}));
  EXPECT_EQ(file.float64("none", 2, &shape), std::vector<double>{});
  EXPECT_EQ(shape, (Shape{0, 4}));
  EXPECT_EQ(file.text("about"), "{\"arm\": \"é τ\"}");
  EXPECT_FALSE(file.has("pose.npy"));
}

TEST(Npz, EqualArraysAreEqualBytes) {
  EXPECT_EQ(sample().bytes(), sample().bytes());
}

TEST(Npz, NumPyReadsIt) {
  if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) GTEST_SKIP() << "python3 has no numpy";
  const Folder folder;
  const std::string path = folder.path + "/a.npz";
  sample().write(path);
  const std::string script =
      "import numpy as np, zipfile\n"
      "assert zipfile.ZipFile('" +
      path +
      "').testzip() is None\n"
      "z = np.load('" +
      path +
      "')\n"
      "assert sorted(z.files) == ['about', 'cells', 'flags', 'index', 'none', 'pose', 'single'], z.files\n"
      "assert z['pose'].dtype == np.float64 and (z['pose'] == [[1.5, -2, 1e300], [0, np.inf, 6]]).all()\n"
      "assert z['single'].dtype == np.float32 and z['single'][0] == 0.25\n"
      "assert z['flags'].dtype == np.uint32 and list(z['flags']) == [1, 4294967295]\n"
      "assert z['cells'].shape == (1, 3, 1) and z['cells'].dtype == np.uint8 and z['cells'].max() == 255\n"
      "assert z['index'].dtype == np.int64 and list(z['index']) == [-1, 2**63 - 1]\n"
      "assert z['none'].shape == (0, 4)\n"
      "assert bytes(z['about']).decode() == '{\"arm\": \"é τ\"}'\n"
      "np.savez('" +
      folder.path +
      "/b.npz', x=np.arange(6.).reshape(2, 3), flags=np.uint32([7]))\n"
      "np.savez_compressed('" +
      folder.path +
      "/c.npz', x=np.zeros(9))\n"
      "np.savez('" +
      folder.path +
      "/d.npz', x=np.asfortranarray(np.zeros((2, 2))))\n"
      "np.savez('" +
      folder.path + "/e.npz', x=np.array(['text']))\n";
  write_file(folder.path + "/check.py", script);
  ASSERT_EQ(std::system(("/usr/bin/python3 " + folder.path + "/check.py").c_str()), 0);

  const NpzReader theirs(folder.path + "/b.npz");
  Shape shape;
  EXPECT_EQ(theirs.float64("x", 2, &shape), (std::vector<double>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(shape, (Shape{2, 3}));
  EXPECT_EQ(theirs.uint32("flags", 1), std::vector<std::uint32_t>{7});
  const auto refused = [&](const char* name) { return reason(read_file(folder.path + name)); };
  EXPECT_EQ(refused("/c.npz"), "x.npz is damaged: array \"x.npy\": compressed, expected a stored entry");
  EXPECT_EQ(refused("/d.npz"), "x.npz is damaged: array \"x.npy\": Fortran order, expected C order");
  EXPECT_EQ(refused("/e.npz"), "x.npz is damaged: array \"x.npy\": type \"<U4\", expected <f8, <f4, <u4, |u1 or <i8");
}

TEST(Npz, RefusesAWrongShapeAndATakenName) {
  NpzWriter file;
  file.add("x", std::vector<double>{1, 2}, {2});
  EXPECT_THROW(file.add("y", std::vector<double>{1, 2}, {3}), std::invalid_argument);
  EXPECT_THROW(file.add("y", std::vector<double>{1, 2}, {1ull << 33, 1ull << 33}), std::invalid_argument);
  EXPECT_THROW(file.add("x", std::vector<double>{1}, {1}), std::invalid_argument);
}

TEST(Npz, SaysWhatIsMissing) {
  const std::string bytes = sample().bytes();
  const NpzReader file(bytes, "x.npz");
  const auto what = [&](auto&& read) -> std::string {
    try {
      read();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(what([&] { file.float64("speed", 1); }), "x.npz is damaged: array \"speed\" is missing");
  EXPECT_EQ(what([&] { file.uint32("pose", 2); }),
            "x.npz is damaged: array \"pose\": expected values of type <u4, found <f8");
  EXPECT_EQ(what([&] { file.float64("pose", 1); }), "x.npz is damaged: array \"pose\": expected 1 dimensions, found 2");
}

TEST(Npz, EveryTruncationIsAnError) {
  const std::string bytes = sample().bytes();
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_NE(reason(std::string_view(bytes).substr(0, n)), "") << n;
  EXPECT_EQ(reason(""), "x.npz is damaged: not an NPZ file");
  EXPECT_EQ(reason(bytes.substr(0, bytes.size() - 1)), "x.npz is damaged: not an NPZ file, or its end is cut off");
}

TEST(Npz, AChangedValueFailsTheChecksum) {
  std::string bytes = sample().bytes();
  bytes[bytes.find("NUMPY") + 130] ^= 1;
  EXPECT_EQ(reason(bytes), "x.npz is damaged: array \"pose.npy\": its checksum does not agree");
}

TEST(Npz, NoChangedByteCrashesTheReader) {
  const std::string good = sample().bytes();
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = good;
    for (int k = 0; k < 1 + i % 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    refused += reason(bytes) != "";
  }
  EXPECT_GT(refused, 10000);
}

TEST(Npz, ANamelessFileIsAnError) {
  try {
    NpzReader("/nowhere/x.npz");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cannot read /nowhere/x.npz: No such file or directory");
  }
}

}  // namespace
}  // namespace wend::core
