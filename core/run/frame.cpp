#include <core/run/frame.hpp>

#include <sys/socket.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>

namespace wend::core {
namespace {

struct Header {
  char magic[4];
  std::uint32_t length;
  std::uint64_t nonce;
  std::uint32_t crc, reserved;
};
static_assert(sizeof(Header) == 24);
constexpr char magic[4] = {'W', 'N', 'D', '1'};

std::uint32_t crc_of(std::string_view payload) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(payload.data()), payload.size()));
}

void check(const Header& header, std::uint64_t nonce) {
  if (std::memcmp(header.magic, magic, sizeof magic) != 0) throw FrameError{"expected a frame, found other bytes"};
  if (header.nonce != nonce) throw FrameError{"expected this worker's frame, found another's"};
  if (header.length > frame_limit)
    throw FrameError{"expected at most " + std::to_string(frame_limit) + " bytes, found " + std::to_string(header.length)};
}

}  // namespace

std::string encode_frame(std::string_view payload, std::uint64_t nonce) {
  if (payload.size() > frame_limit)
    throw FrameError{"expected at most " + std::to_string(frame_limit) + " bytes, found " + std::to_string(payload.size())};
  Header header{};
  std::memcpy(header.magic, magic, sizeof magic);
  header.length = static_cast<std::uint32_t>(payload.size());
  header.nonce = nonce;
  header.crc = crc_of(payload);
  std::string frame(sizeof header, '\0');
  std::memcpy(frame.data(), &header, sizeof header);
  frame += payload;
  return frame;
}

std::optional<std::string> decode_frame(std::string& buffer, std::uint64_t nonce) {
  Header header;
  if (buffer.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, buffer.data(), sizeof header);
  check(header, nonce);
  if (buffer.size() - sizeof header < header.length) return std::nullopt;
  std::string payload = buffer.substr(sizeof header, header.length);
  if (crc_of(payload) != header.crc) throw FrameError{"a frame's checksum does not fit its bytes"};
  buffer.erase(0, sizeof header + header.length);
  return payload;
}

void write_frame(int fd, std::string_view payload, std::uint64_t nonce) {
  const std::string frame = encode_frame(payload, nonce);
  for (std::size_t done = 0; done < frame.size();) {
    const ssize_t n = ::send(fd, frame.data() + done, frame.size() - done, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw FrameError{std::string("cannot send a frame: ") + std::strerror(errno)};
    done += static_cast<std::size_t>(n);
  }
}

std::optional<std::string> read_frame(int fd, std::uint64_t nonce) {
  std::string buffer;
  while (true) {
    if (auto payload = decode_frame(buffer, nonce)) return payload;
    char bytes[65536];
    const ssize_t n = ::recv(fd, bytes, sizeof bytes, 0);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FrameError{std::string("cannot receive a frame: ") + std::strerror(errno)};
    if (n == 0) return std::nullopt;
    buffer.append(bytes, static_cast<std::size_t>(n));
  }
}

}  // namespace wend::core
