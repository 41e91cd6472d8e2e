// Encoding of observations: see encoder.hpp.
#include "encoder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <wend/math.hpp>

namespace xcs {
namespace {

constexpr std::size_t most_bits = 1024;

std::string short_number(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::uint64_t gray(std::uint64_t k) noexcept {
  return k ^ (k >> 1);
}

// Writes the lowest `width` bits of a number from bit `at` of the message on, which is 0 there.
void put(std::uint64_t* message, std::size_t& at, std::uint64_t number, std::uint32_t width) noexcept {
  message[at / 64] |= number << at % 64;
  if (at % 64 + width > 64) message[at / 64 + 1] |= number >> (64 - at % 64);
  at += width;
}

}  // namespace

Encoder::Encoder(wend::Space observation, const wend::Params& params, const std::string& parameter) {
  const std::size_t n = params.size(parameter);
  for (std::size_t i = 0; i < n; ++i) {
    const std::string path = wend::Params::element(parameter, i);
    Part part;
    part.columns = wend::Reading(observation, params.texts(path + "/columns"), path + "/columns");
    const std::string as = params.text(path + "/as");
    if (as == "thermometer") {
      part.thresholds = params.numbers(path + "/thresholds");
      add_thermometer(std::move(part), path);
    } else if (as == "sectors") {
      part.sectors = params.count(path + "/sectors");
      add_sectors(std::move(part), path);
    } else if (as == "binary") {
      add_binary(std::move(part), path);
    } else {
      throw wend::parameter_error(path + "/as", "expected thermometer, sectors or binary, found " + as);
    }
    if (names_.size() > most_bits)
      throw wend::parameter_error(path, "expected a message of at most " + std::to_string(most_bits) + " bits, found " +
                                            std::to_string(names_.size()) +
                                            ": encode fewer columns or use fewer thresholds");
  }
  if (names_.empty()) throw wend::parameter_error(parameter, "expected at least one bit to match on, found none");
}

void Encoder::add_thermometer(Part part, const std::string& path) {
  part.as = As::thermometer;
  if (part.thresholds.empty()) throw wend::parameter_error(path + "/thresholds", "expected thresholds, found none");
  for (std::size_t k = 0; k < part.thresholds.size(); ++k)
    if (!std::isfinite(part.thresholds[k]) || (k > 0 && part.thresholds[k] <= part.thresholds[k - 1]))
      throw wend::parameter_error(
          wend::Params::element(path + "/thresholds", k),
          "expected finite thresholds in ascending order, found " + short_number(part.thresholds[k]));
  for (std::size_t c = 0; c < part.columns.size(); ++c)
    for (const double threshold : part.thresholds) {
      names_.push_back(std::string(part.columns.column(c).name) + "<" + short_number(threshold));
      signature_ += names_.back() + ";";
    }
  parts_.push_back(std::move(part));
}

void Encoder::add_sectors(Part part, const std::string& path) {
  part.as = As::sectors;
  if (part.sectors < 2 || !std::has_single_bit(part.sectors))
    throw wend::parameter_error(path + "/sectors",
                                "expected a power of two from 2 on, found " + std::to_string(part.sectors));
  const auto bits = static_cast<std::uint32_t>(std::countr_zero(part.sectors));
  for (std::size_t c = 0; c < part.columns.size(); ++c) {
    const wend_column& column = part.columns.column(c);
    if (std::string_view(column.unit) != "rad")
      throw wend::parameter_error(path + "/columns", "expected angles in rad for sectors, found \"" +
                                                         std::string(column.name) + "\" in " + column.unit);
    for (std::uint32_t b = 0; b < bits; ++b) {
      names_.push_back(std::string(column.name) + ".g" + std::to_string(b));
      signature_ += names_.back() + "/" + std::to_string(part.sectors) + ";";
    }
  }
  parts_.push_back(std::move(part));
}

void Encoder::add_binary(Part part, const std::string& path) {
  part.as = As::binary;
  for (std::size_t c = 0; c < part.columns.size(); ++c) {
    const wend_column& column = part.columns.column(c);
    if (column.count < 2)
      throw wend::parameter_error(path + "/columns", "expected columns of whole numbers for binary, found \"" +
                                                         std::string(column.name) + "\" in " + column.unit +
                                                         ": encode it as thermometer or sectors");
    const auto bits = static_cast<std::uint32_t>(std::bit_width(column.count - 1));
    part.width.push_back(bits);
    for (std::uint32_t b = 0; b < bits; ++b) {
      names_.push_back(bits == 1 ? std::string(column.name) : std::string(column.name) + ".b" + std::to_string(b));
      signature_ += names_.back() + "/" + std::to_string(column.count) + ";";
    }
  }
  parts_.push_back(std::move(part));
}

void Encoder::encode(std::span<const double> observation, std::uint64_t* message) const {
  std::fill_n(message, words(), 0);
  std::size_t at = 0;
  for (const Part& part : parts_) {
    for (std::size_t c = 0; c < part.columns.size(); ++c) {
      const double value = part.columns(observation, c);
      if (part.as == As::thermometer) {
        for (const double threshold : part.thresholds) put(message, at, value < threshold, 1);
      } else if (part.as == As::sectors) {
        const double sector = wend::math::wrap_angle(value) / (2 * wend::math::pi) * static_cast<double>(part.sectors);
        const auto k = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(sector + 0.5)));
        put(message, at, gray(k & (part.sectors - 1)), static_cast<std::uint32_t>(std::countr_zero(part.sectors)));
      } else {
        const auto count = static_cast<double>(part.columns.column(c).count);
        if (!(value >= 0 && value < count) || value != std::floor(value))
          throw wend::Error(WEND_E_ARGUMENT, {},
                            "observation \"" + std::string(part.columns.column(c).name) +
                                "\": expected a whole number 0.." + short_number(count - 1) + ", found " +
                                short_number(value));
        put(message, at, static_cast<std::uint64_t>(value), part.width[c]);
      }
    }
  }
}

}  // namespace xcs
