// What every part of the resolution of an experiment file works with, and how it says what is wrong.
#pragma once
#include <core/base/diagnostics.hpp>
#include <core/base/document.hpp>
#include <core/experiment/assets.hpp>
#include <core/plugin/catalog.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

struct Scope {
  const Document& document;
  const Catalog& catalog;
  Assets& assets;
  Diagnostics& diagnostics;

  void error(const std::string& pointer, std::string message, std::string hint = "", bool key = false) const;

  // Unknown `what` `word`, such as: unknown world "ordinry" in arm "mine".
  void unknown(const std::string& pointer, const std::string& what, const std::string& word, const std::string& where,
               const std::vector<std::string>& known, bool key = false) const;

  // Checks `value` by the part of the experiment's schema called `part` and fills its defaults in.
  void check(const std::string& part, Json& value, const std::string& pointer, const std::string& subject) const;

  // True where `id` can be the id of a `what`: it becomes part of file names and of command lines.
  bool check_id(const std::string& pointer, const std::string& what, const std::string& id) const;

  // `ids` are those of the elements of the array at `pointer`; "" stands for one that was reported.
  void check_unique(const std::string& what, const std::string& pointer, const std::vector<std::string>& ids) const;

  void report_assets() const;  // what the assets found wrong since the last call
};

std::string element(const std::string& pointer, std::size_t i);  // of an array

// What is there and has the right type; mistakes in the type were reported by the schema.
const Json* member(const Json& object, const char* key);
std::string text_in(const Json& object, const char* key);                    // "" if it is not there
std::optional<std::uint64_t> count_in(const Json& object, const char* key);  // nothing if it is not there

}  // namespace wend::core
