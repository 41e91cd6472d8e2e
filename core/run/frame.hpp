// Frames on the private descriptor between the host and a worker: magic, length, nonce and CRC, because a plugin can write
// to every descriptor it finds.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace wend::core {

struct FrameError {
  std::string message;
};

constexpr std::uint32_t frame_limit = 1u << 30;  // bytes of payload

std::string encode_frame(std::string_view payload, std::uint64_t nonce);

// Takes the first whole frame off `buffer`; nothing while it is incomplete.  Throws FrameError where the bytes are no frame.
std::optional<std::string> decode_frame(std::string& buffer, std::uint64_t nonce);

// Blocking, for the worker's side.  read: nothing at the end of the stream.
void write_frame(int fd, std::string_view payload, std::uint64_t nonce);
std::optional<std::string> read_frame(int fd, std::uint64_t nonce);

}  // namespace wend::core
