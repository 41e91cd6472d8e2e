// SHA-256, for ids, fingerprints and the content of files.
#pragma once
#include <string>
#include <string_view>

namespace wend::core {

std::string sha256(std::string_view bytes);            // 64 hexadecimal digits
std::string sha256_of_file(const std::string& path);   // throws Error(Exit::data)

}  // namespace wend::core
