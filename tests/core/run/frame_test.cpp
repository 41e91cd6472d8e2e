#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <core/run/frame.hpp>
#include <thread>

namespace wend::core {
namespace {

std::string error_of(std::string bytes, std::uint64_t nonce = 5) {
  try {
    decode_frame(bytes, nonce);
  } catch (const FrameError& error) {
    return error.message;
  }
  return "nothing";
}

TEST(Frame, TakesWholeFramesOffTheBuffer) {
  std::string buffer = encode_frame("one", 5) + encode_frame("", 5) + encode_frame(std::string("t\0o", 3), 5);
  EXPECT_EQ(buffer.size(), 3 * 24 + 6u);
  EXPECT_EQ(decode_frame(buffer, 5), "one");
  EXPECT_EQ(decode_frame(buffer, 5), "");
  EXPECT_EQ(decode_frame(buffer, 5), std::string("t\0o", 3));
  EXPECT_TRUE(buffer.empty());
  EXPECT_EQ(decode_frame(buffer, 5), std::nullopt);
}

TEST(Frame, WaitsForTheLastByte) {
  const std::string frame = encode_frame("payload", 5);
  for (std::size_t n = 0; n < frame.size(); ++n) {
    std::string part = frame.substr(0, n);
    EXPECT_EQ(decode_frame(part, 5), std::nullopt) << n;
    EXPECT_EQ(part.size(), n);
  }
}

TEST(Frame, RefusesOtherBytes) {
  const std::string frame = encode_frame("payload", 5);
  EXPECT_EQ(error_of(std::string(24, 'x')), "expected a frame, found other bytes");
  EXPECT_EQ(error_of(frame, 6), "expected this worker's frame, found another's");
  for (std::size_t i = 24; i < frame.size(); ++i) {
    std::string changed = frame;
    changed[i] ^= 1;
    EXPECT_EQ(error_of(changed), "a frame's checksum does not fit its bytes");
  }
  std::string endless = frame;
  endless[7] = '\x7f';
  EXPECT_EQ(error_of(endless), "expected at most 1073741824 bytes, found 2130706439");
}

TEST(Frame, TravelsOverASocket) {
  int pair[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, pair), 0);
  const std::string large(3 << 20, 'z');  // more than the socket holds
  std::thread sender([&] {
    write_frame(pair[0], large, 9);
    write_frame(pair[0], "end", 9);
    ::close(pair[0]);
  });
  EXPECT_EQ(read_frame(pair[1], 9), large + "");
  sender.join();
  ::close(pair[1]);
}

TEST(Frame, TellsOfADescriptorThatIsGone) {
  const auto error = [](auto&& body) -> std::string {
    try {
      body();
    } catch (const FrameError& failed) {
      return failed.message;
    }
    return "nothing";
  };
  EXPECT_EQ(error([] { write_frame(-1, "x", 1); }), "cannot send a frame: Bad file descriptor");
  EXPECT_EQ(error([] { read_frame(-1, 1); }), "cannot receive a frame: Bad file descriptor");
}

}  // namespace
}  // namespace wend::core
