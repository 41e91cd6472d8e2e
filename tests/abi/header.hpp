// What abi.h declares, read from its text: structs with their members in order, constants, names of interfaces.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace wend::test {

struct Struct {
  std::string name;
  bool frozen = false;
  std::vector<std::pair<std::string, std::string>> members;  // name, whole declaration with single spaces
};

struct Header {
  std::vector<Struct> structs;
  std::vector<std::pair<std::string, std::string>> constants;  // of its enums: name, value as written
  std::vector<std::pair<std::string, std::string>> texts;      // #define NAME "text"
};

Header read_header(const std::string& path);

// A C program that prints the offset and size of every member, and every constant, one a line, with the header at
// `path` compiled in.
std::string layout_program(const Header& header, const std::string& path);

}  // namespace wend::test
