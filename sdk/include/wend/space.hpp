// wend/space.hpp -- columns with names and units: building them, and picking them by name.
#pragma once
#include <wend/error.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wend {

// The columns that a component offers.  It owns the names, so the table it hands out lives as long as it does.
class Columns {
 public:
  Columns() = default;
  Columns(const Columns&) = delete;  // the table points into the names
  Columns& operator=(const Columns&) = delete;

  // A number in low..high; `at` is where it was taken (the bearing of a beam, rad).
  Columns& box(const std::string& name, const std::string& unit, double low = -std::numeric_limits<double>::infinity(),
               double high = std::numeric_limits<double>::infinity(), double at = 0) {
    return add({low, high, 0, at, nullptr, nullptr}, name, unit);
  }
  // One of the whole numbers 0..count-1.
  Columns& discrete(const std::string& name, std::uint64_t count) {
    return add({0, static_cast<double>(count) - 1, count, 0, nullptr, nullptr}, name, "1");
  }

  std::size_t width() const noexcept { return columns_.size(); }
  const wend_column& operator[](std::size_t i) const noexcept { return columns_[i]; }
  const wend_space* table() const noexcept { return &space_; }

 private:
  Columns& add(wend_column column, const std::string& name, const std::string& unit) {
    column.name = keep(name);
    column.unit = keep(unit);
    columns_.push_back(column);
    space_ = {sizeof(wend_space), static_cast<std::uint32_t>(columns_.size()), columns_.data()};
    return *this;
  }

  const char* keep(const std::string& text) {
    return texts_.emplace_back(text.c_str(), text.c_str() + text.size() + 1).data();
  }

  std::vector<std::vector<char>> texts_;  // a vector<char> that moves takes its characters along: they stay in place
  std::vector<wend_column> columns_;
  wend_space space_{sizeof(wend_space), 0, nullptr};
};

// True if `name` fits `pattern`, where each * stands for any run of characters.
inline bool matches(std::string_view pattern, std::string_view name) noexcept {
  std::size_t p = 0, n = 0, star = std::string_view::npos, mark = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      mark = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++mark;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

// A space that somebody else owns: the observations or actions that a component is handed.
class Space {
 public:
  Space() = default;
  explicit Space(const wend_space* space) noexcept : space_(space) {}

  explicit operator bool() const noexcept { return space_ != nullptr; }
  std::size_t width() const noexcept { return space_ ? space_->width : 0; }
  const wend_column& operator[](std::size_t i) const noexcept { return space_->columns[i]; }
  std::span<const wend_column> columns() const noexcept { return {space_ ? space_->columns : nullptr, width()}; }

  // The indices of the columns that fit each pattern in turn.  Throws where a pattern fits none; `parameter` is the one
  // that held the patterns.
  std::vector<std::uint32_t> select(const std::vector<std::string>& patterns, const std::string& parameter) const {
    std::vector<std::uint32_t> picked;
    for (std::size_t k = 0; k < patterns.size(); ++k) {
      const std::size_t before = picked.size();
      for (std::uint32_t i = 0; i < width(); ++i)
        if (matches(patterns[k], space_->columns[i].name)) picked.push_back(i);
      if (picked.size() == before)
        throw parameter_error(parameter + "/" + std::to_string(k),
                              "no column fits \"" + patterns[k] + "\"; the columns are " + names());
    }
    return picked;
  }

  // The index of the one column of that name.
  std::uint32_t index(const std::string& name, const std::string& parameter) const {
    const auto picked = select({name}, parameter);
    if (picked.size() != 1) throw parameter_error(parameter, "\"" + name + "\" fits several columns, expected one");
    return picked.front();
  }

  std::string names() const {
    std::string all;
    for (const wend_column& column : columns()) all += (all.empty() ? "" : ", ") + std::string(column.name);
    return all.empty() ? "none" : all;
  }

 private:
  const wend_space* space_ = nullptr;
};

}  // namespace wend
