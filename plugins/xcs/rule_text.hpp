// Rule bases for people and other programs: a text that can be read back, and JSON.
//
//   wend rules 1
//   encoding cell.0/2;cell.1/2;
//   actions 2
//   // condition action prediction error fitness experience set_size numerosity
//   01####1 0 1000 0 0.98 341 12.5 14
//
// A line that starts with "//" is a remark.
#pragma once
#include <string>
#include <string_view>

#include "population.hpp"

namespace xcs {

std::string format_rules(const Population& population, const std::string& encoding);
std::string format_json(const Population& population, const std::string& encoding);

// Reads format_rules' text into an empty population; every rule is marked as seeded.  Errors name `parameter`, and the
// line; the population is left as it was.
void read_rules(std::string_view text, const std::string& encoding, const std::string& parameter, Population& into);

std::string shortest(double number);  // the fewest digits that read back to the same number

}  // namespace xcs
