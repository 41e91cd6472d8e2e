#include "rule_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>
#include <wend/error.hpp>

namespace xcs {
namespace {

constexpr std::string_view title = "wend rules 1";
constexpr const char* columns = "condition action prediction error fitness experience set_size numerosity";

// Lines of a rule file, with their numbers; remarks and empty lines are skipped.
class Lines {
 public:
  Lines(std::string_view text, const std::string& parameter) : left_(text), parameter_(parameter) {}
  bool next(std::string_view& line) {
    while (!left_.empty()) {
      const std::size_t end = std::min(left_.find('\n'), left_.size());
      line = left_.substr(0, end);
      left_.remove_prefix(std::min(end + 1, left_.size()));
      ++number_;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      if (!line.empty() && line.substr(0, 2) != "//") return true;
    }
    return false;
  }
  [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
    std::string shown(found.substr(0, 60));
    for (char& c : shown)
      if (c < ' ' || c > '~') c = '?';  // a file that is no text
    throw wend::parameter_error(parameter_, "line " + std::to_string(number_) + ": expected " + expected +
                                                ", found \"" + shown + (found.size() > 60 ? "..." : "") + "\"");
  }
  [[noreturn]] void ends(const std::string& expected) const {
    throw wend::parameter_error(parameter_, "expected " + expected + ", found the end of the file");
  }

 private:
  std::string_view left_;
  const std::string& parameter_;
  std::size_t number_ = 0;
};

std::string_view word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  const std::string_view found = line.substr(0, line.find_first_of(" \t"));
  line.remove_prefix(found.size());
  return found;
}

// The name of the next bit of an encoding, which ends with a semicolon; empty after the last.
std::string_view next_bit(std::string_view& encoding) {
  const std::string_view name = encoding.substr(0, encoding.find(';'));
  encoding.remove_prefix(std::min(name.size() + 1, encoding.size()));
  return name;
}

// Names the first bit that is another one: encodings are long.
void check_encoding(std::string_view line, std::string_view encoding, const Lines& lines) {
  const std::string_view key = "encoding ";
  if (line.substr(0, key.size()) != key) lines.fail("\"encoding\" and the names of its bits", line);
  std::string_view found = line.substr(key.size());
  if (found == encoding) return;
  for (std::size_t bit = 0;; ++bit) {
    const std::string_view own = next_bit(encoding), other = next_bit(found);
    if (own == other && !(own.empty() && other.empty())) continue;
    const std::string place = "the encoding of this observation, with bit " + std::to_string(bit) + " ";
    lines.fail(own.empty() ? "the encoding of this observation, of " + std::to_string(bit) + " bits"
                           : place + "\"" + std::string(own) + "\"",
               other);
  }
}

double number(std::string_view& line, const Lines& lines, const char* name, double least) {
  const std::string_view text = word(line);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || value < least)
    lines.fail(std::string(name) + ": a number" + (std::isfinite(least) ? " >= " + shortest(least) : ""), text);
  return value;
}

void read_rule(std::string_view line, const Lines& lines, Population& into) {
  const std::string_view whole = line, condition = word(line);
  std::vector<std::uint64_t> care, value;
  if (!parse_condition(condition, into.bits(), care, value))
    lines.fail("a condition of " + std::to_string(into.bits()) + " characters 0, 1 or #", condition);
  const double action = number(line, lines, "action", 0);
  if (action >= into.actions() || action != std::floor(action))
    lines.fail("an action 0.." + std::to_string(into.actions() - 1), shortest(action));
  Numbers n;
  n.prediction = number(line, lines, "prediction", -INFINITY);
  n.error = number(line, lines, "error", 0);
  n.fitness = number(line, lines, "fitness", 0);
  n.experience = number(line, lines, "experience", 0);
  n.set_size = number(line, lines, "set_size", 0);
  n.numerosity = number(line, lines, "numerosity", 1);
  n.marks = kSeeded;
  if (n.numerosity != std::floor(n.numerosity)) lines.fail("numerosity: a whole number", shortest(n.numerosity));
  if (!word(line).empty()) lines.fail(std::string("a rule: ") + columns, whole);
  if (into.find(care.data(), value.data(), static_cast<std::uint32_t>(action)) != Population::none)
    lines.fail("each condition with an action once", whole);
  into.add(care.data(), value.data(), static_cast<std::uint32_t>(action), n);
}

}  // namespace

std::string shortest(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

std::string format_rules(const Population& population, const std::string& encoding) {
  std::string text = std::string(title) + "\nencoding " + encoding + "\nactions " +
                     std::to_string(population.actions()) + "\n// " + columns + "\n";
  for (std::uint32_t rule = 0; rule < population.size(); ++rule) {
    const Numbers n = population.numbers(rule);
    text += population.condition(rule) + " " + std::to_string(population.action(rule));
    for (const double number : {n.prediction, n.error, n.fitness, n.experience, n.set_size, n.numerosity})
      text += " " + shortest(number);
    text += "\n";
  }
  return text;
}

std::string format_json(const Population& population, const std::string& encoding) {
  std::string quoted;
  for (const char c : encoding) quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  std::string text = "{\"format\": \"" + std::string(title) + "\", \"encoding\": \"" + quoted +
                     "\", \"actions\": " + std::to_string(population.actions()) + ", \"rules\": [";
  for (std::uint32_t rule = 0; rule < population.size(); ++rule) {
    const Numbers n = population.numbers(rule);
    text += std::string(rule ? ",\n" : "\n") + "  {\"condition\": \"" + population.condition(rule) +
            "\", \"action\": " + std::to_string(population.action(rule)) +
            ", \"prediction\": " + shortest(n.prediction) + ", \"error\": " + shortest(n.error) +
            ", \"fitness\": " + shortest(n.fitness) + ", \"experience\": " + shortest(n.experience) +
            ", \"set_size\": " + shortest(n.set_size) + ", \"numerosity\": " + shortest(n.numerosity) + "}";
  }
  return text + "]}\n";
}

void read_rules(std::string_view text, const std::string& encoding, const std::string& parameter, Population& into) {
  Population read(into.bits(), into.actions());
  Lines lines(text, parameter);
  std::string_view line;
  const auto header = [&](const std::string& expected) {
    if (!lines.next(line)) lines.ends("\"" + expected + "\"");
    if (line != expected) lines.fail("\"" + expected + "\"", line);
  };
  header(std::string(title));
  if (!lines.next(line)) lines.ends("\"encoding\" and the names of its bits");
  check_encoding(line, encoding, lines);
  header("actions " + std::to_string(into.actions()));
  while (lines.next(line)) read_rule(line, lines, read);
  into = read;
}

}  // namespace xcs
