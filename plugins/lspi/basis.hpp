// State basis functions phi(s) of a linear Q function.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>
#include <wend/config.hpp>

namespace lspi {

class Basis {
 public:
  virtual ~Basis() = default;
  virtual std::size_t size() const noexcept = 0;  // m
  // phi(s): m values for a state of n; both spans have exactly these sizes.
  virtual void evaluate(std::span<const double> state, std::span<double> features) const noexcept = 0;
  // What tells states of other bases apart: name and sizes; ranges or centres and width.
  virtual std::string name() const = 0;
  virtual std::vector<double> constants() const = 0;
};

// Range of one state variable; powers and monomials are taken of it scaled to [-1, 1].
struct Range {
  double low, high;
  double scaled(double value) const noexcept { return 2 * (value - low) / (high - low) - 1; }
};

// 1 and the powers 1..degree of each variable: m = 1 + n degree.
std::unique_ptr<Basis> powers(std::vector<Range> ranges, std::size_t degree);

// All monomials of total degree at most `degree` (the paper's "fourth-order polynomial" read whole): m = C(n + degree,
// degree).
std::unique_ptr<Basis> monomials(std::vector<Range> ranges, std::size_t degree);

// 1 and Gaussians exp(-|s - c|^2 / (2 width^2)) around the grid of all combinations of `centres`, one list per
// variable, in the variables' own units (Lagoudakis & Parr 2003, section 9.2).
std::unique_ptr<Basis> gaussians(std::vector<std::vector<double>> centres, double width);

}  // namespace lspi
