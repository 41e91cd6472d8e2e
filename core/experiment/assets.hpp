// The files that an experiment names: found, and hashed, so that ids speak of what they hold and not of where they are.
#pragma once
#include <core/base/json.hpp>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace wend::core {

class Assets {
 public:
  // What is wrong with a file's name: a message and what to do.
  struct Problem {
    std::string pointer, message, hint;
  };

  // Names are relative to `directory`, in which ${NAME} stands for one of `variables`.
  Assets(std::string directory, std::map<std::string, std::string> variables);

  // The absolute paths that `name` stands for, sorted: the file of that name, or, if `pattern`, all that match it.
  std::vector<std::string> find(const std::string& name, bool pattern, const std::string& pointer);
  std::string hash_of(const std::string& path, const std::string& pointer);

  // Makes absolute paths of all texts in `value` to which the schema gives the format "file" or "files", and notes
  // their hashes in `content`.  A single text serves as an array of "files".  Returns the length of the longest of such
  // arrays.
  std::uint32_t resolve(const Json& schema, Json& value, const std::string& pointer, Json& content);

  std::vector<Problem> take_problems();

 private:
  std::uint32_t expand(Json& value, const std::string& pointer, Json& content);
  std::string substituted(const std::string& name, const std::string& pointer);

  std::string directory_;
  std::map<std::string, std::string> variables_, hashes_;
  std::vector<Problem> problems_;
};

}  // namespace wend::core
