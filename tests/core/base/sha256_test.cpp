#include <gtest/gtest.h>

#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/base/sha256.hpp>

namespace wend::core {
namespace {

// FIPS 180-4 and NIST's example vectors.
TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_NE(sha256(std::string("a\0b", 3)), sha256("a"));
}

TEST(Sha256, OfAFile) {
  const std::string path = testing::TempDir() + "wend_sha256_test";
  write_file(path, "abc");
  EXPECT_EQ(sha256_of_file(path), sha256("abc"));
  std::remove(path.c_str());
  EXPECT_THROW(sha256_of_file(path), Error);
}

}  // namespace
}  // namespace wend::core
