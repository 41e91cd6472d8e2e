#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/base/sha256.hpp>

#include <openssl/evp.h>

namespace wend::core {

std::string sha256(std::string_view bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int n = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &n, EVP_sha256(), nullptr) != 1)
    throw Error(Exit::data, "SHA-256 is not available in this build of OpenSSL");
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < n; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

std::string sha256_of_file(const std::string& path) { return sha256(read_file(path)); }

}  // namespace wend::core
