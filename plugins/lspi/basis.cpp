#include "basis.hpp"

#include <utility>
#include <wend/math.hpp>

namespace lspi {
namespace {

std::vector<double> ends(const std::vector<Range>& ranges) {
  std::vector<double> all;
  for (const Range& range : ranges) all.insert(all.end(), {range.low, range.high});
  return all;
}

class Powers : public Basis {
 public:
  Powers(std::vector<Range> ranges, std::size_t degree) : ranges_(std::move(ranges)), degree_(degree) {}
  std::size_t size() const noexcept override { return 1 + ranges_.size() * degree_; }
  void evaluate(std::span<const double> state, std::span<double> features) const noexcept override {
    std::size_t k = 0;
    features[k++] = 1;
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const double x = ranges_[i].scaled(state[i]);
      double power = 1;
      for (std::size_t d = 0; d < degree_; ++d) features[k++] = power *= x;
    }
  }
  std::string name() const override {
    return "powers " + std::to_string(ranges_.size()) + " " + std::to_string(degree_);
  }
  std::vector<double> constants() const override { return ends(ranges_); }

 private:
  std::vector<Range> ranges_;
  std::size_t degree_;
};

class Monomials : public Basis {
 public:
  Monomials(std::vector<Range> ranges, std::size_t degree) : ranges_(std::move(ranges)), degree_(degree) {
    factors_.push_back({0, 0});
    // Each monomial of degree d is one of degree d - 1 times a variable not before its last: none comes twice.
    std::vector<std::pair<std::size_t, std::size_t>> level{{0, 0}};  // (monomial, least variable that may follow)
    for (std::size_t d = 0; d < degree_; ++d) {
      std::vector<std::pair<std::size_t, std::size_t>> grown;
      for (const auto& [monomial, least] : level)
        for (std::size_t v = least; v < ranges_.size(); ++v) {
          grown.emplace_back(factors_.size(), v);
          factors_.push_back({monomial, v});
        }
      level = std::move(grown);
    }
  }
  std::size_t size() const noexcept override { return factors_.size(); }
  void evaluate(std::span<const double> state, std::span<double> features) const noexcept override {
    features[0] = 1;
    for (std::size_t v = 0; v < ranges_.size(); ++v) features[1 + v] = ranges_[v].scaled(state[v]);
    for (std::size_t k = 1 + ranges_.size(); k < factors_.size(); ++k)
      features[k] = features[factors_[k].first] * features[1 + factors_[k].second];
  }
  std::string name() const override {
    return "monomials " + std::to_string(ranges_.size()) + " " + std::to_string(degree_);
  }
  std::vector<double> constants() const override { return ends(ranges_); }

 private:
  std::vector<Range> ranges_;
  std::size_t degree_;
  std::vector<std::pair<std::size_t, std::size_t>>
      factors_;  // monomial k = monomial first * variable second; those of degree 1 come first, in order
};

class Gaussians : public Basis {
 public:
  Gaussians(std::vector<std::vector<double>> centres, double width)
      : variables_(centres.size()), scale_(-0.5 / (width * width)) {
    std::vector<std::size_t> at(variables_, 0);
    while (true) {  // counts through the grid, the last variable fastest
      for (std::size_t v = 0; v < variables_; ++v) points_.push_back(centres[v][at[v]]);
      std::size_t v = variables_;
      while (v > 0 && ++at[v - 1] == centres[v - 1].size()) at[--v] = 0;
      if (v == 0) break;
    }
  }
  std::size_t size() const noexcept override { return 1 + points_.size() / variables_; }
  void evaluate(std::span<const double> state, std::span<double> features) const noexcept override {
    features[0] = 1;
    for (std::size_t k = 1; k < size(); ++k) {
      double square = 0;
      for (std::size_t v = 0; v < variables_; ++v) {
        const double d = state[v] - points_[(k - 1) * variables_ + v];
        square += d * d;
      }
      features[k] = wend::math::exp(scale_ * square);
    }
  }
  std::string name() const override { return "gaussians " + std::to_string(variables_) + " " + std::to_string(size()); }
  std::vector<double> constants() const override {
    std::vector<double> all = points_;
    all.push_back(scale_);
    return all;
  }

 private:
  std::size_t variables_;
  double scale_;
  std::vector<double> points_;
};

}  // namespace

std::unique_ptr<Basis> powers(std::vector<Range> ranges, std::size_t degree) {
  return std::make_unique<Powers>(std::move(ranges), degree);
}
std::unique_ptr<Basis> monomials(std::vector<Range> ranges, std::size_t degree) {
  return std::make_unique<Monomials>(std::move(ranges), degree);
}
std::unique_ptr<Basis> gaussians(std::vector<std::vector<double>> centres, double width) {
  return std::make_unique<Gaussians>(std::move(centres), width);
}

}  // namespace lspi
