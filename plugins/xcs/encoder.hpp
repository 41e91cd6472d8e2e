// Observation columns as a string of bits, the message that conditions are matched against.
//
//   thermometer   one bit a threshold, ascending: 1 where the value is below it; 00, 01, 11 for far, near, very near
//   sectors       an angle as the Gray code of its sector: neighbours differ in one bit; sector 0 is centred on 0
//   binary        a discrete column as its number, lowest bit first
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>
#include <wend/config.hpp>
#include <wend/reading.hpp>

namespace xcs {

class Encoder {
 public:
  // Reads the array `parameter`: objects with `columns` (patterns), `as` and what that needs.
  Encoder(wend::Space observation, const wend::Params& params, const std::string& parameter);

  std::size_t bits() const noexcept { return names_.size(); }
  // Bit i of the message, counted from the lowest, has this name: "sonar.range.0<0.35", "goal.bearing.g2", "cell.3.b0".
  const std::vector<std::string>& names() const noexcept { return names_; }
  // Two encoders with equal signatures make equal messages of equal observations.
  const std::string& signature() const noexcept { return signature_; }
  std::size_t words() const noexcept { return (bits() + 63) / 64; }
  // Bit j of the message is bit j % 64 of message[j / 64]; `message` has words() words.
  void encode(std::span<const double> observation, std::uint64_t* message) const;

 private:
  enum class As { thermometer, sectors, binary };
  struct Part {
    As as = As::binary;
    wend::Reading columns;
    std::vector<double> thresholds;    // ascending
    std::uint64_t sectors = 0;         // a power of two
    std::vector<std::uint32_t> width;  // binary: bits of each column
  };
  void add_thermometer(Part part, const std::string& path);
  void add_sectors(Part part, const std::string& path);
  void add_binary(Part part, const std::string& path);

  std::vector<Part> parts_;
  std::vector<std::string> names_;
  std::string signature_;
};

}  // namespace xcs
