// wend/refs.hpp -- calling another component: one in a slot, or one that is lent.  A failed call throws wend::Failed.
#pragma once
#include <wend/bytes.hpp>
#include <wend/space.hpp>
#include <wend/view.hpp>

#include <string>

namespace wend {
namespace detail {

template <class Table>
class Ref {
 public:
  explicit operator bool() const noexcept { return table_ != nullptr; }
  wend_object* self() const noexcept { return self_; }
  const Table* table() const noexcept { return table_; }

 protected:
  Ref() = default;
  Ref(wend_ref ref, const char* id) noexcept
      : self_(ref.self), table_(ref.type ? static_cast<const Table*>(ref.type->query(ref.self, id)) : nullptr) {}
  wend_object* self_ = nullptr;
  const Table* table_ = nullptr;
};

}  // namespace detail

class PolicyRef : public detail::Ref<wend_policy> {
 public:
  PolicyRef() = default;
  explicit PolicyRef(wend_ref ref) noexcept : Ref(ref, WEND_POLICY) {}
  void begin(Rows rows, Episodes episodes) const {
    if (table_->begin) check(table_->begin(self_, rows.data(), static_cast<std::uint32_t>(rows.size()), episodes.data()));
  }
  // observations and actions are packed: row i starts at i * width.
  void act(Rows rows, const double* observations, double* actions) const {
    check(table_->act(self_, rows.data(), static_cast<std::uint32_t>(rows.size()), observations, actions));
  }
};

class LearnerRef : public detail::Ref<wend_learner> {
 public:
  LearnerRef() = default;
  explicit LearnerRef(wend_ref ref) noexcept : Ref(ref, WEND_LEARNER) {}
  std::uint64_t learn(const wend_batch& batch) const {
    std::uint64_t used = 0;
    check(table_->learn(self_, &batch, &used));
    return used;
  }
  void finish() const {
    if (table_->finish) check(table_->finish(self_));
  }
};

class ValuesRef : public detail::Ref<wend_values> {
 public:
  ValuesRef() = default;
  explicit ValuesRef(wend_ref ref) noexcept : Ref(ref, WEND_VALUES) {}
  void values(const double* observations, std::uint32_t n, double* q, double* spread) const {
    check(table_->values(self_, observations, n, q, spread));
  }
};

class BodyRef : public detail::Ref<wend_body> {
 public:
  BodyRef() = default;
  explicit BodyRef(wend_ref ref) noexcept : Ref(ref, WEND_BODY) {}
  wend_limits limits(std::uint32_t robot) const {
    wend_limits out;
    check(table_->limits(self_, robot, &out));
    return out;
  }
  void predict(std::uint32_t robot, std::span<const wend_motion> from, const double* actions, double seconds,
               std::span<wend_motion> to) const {
    check(table_->predict(self_, robot, from.data(), actions, static_cast<std::uint32_t>(from.size()), seconds, to.data()));
  }
};

class GeometryRef : public detail::Ref<wend_geometry2d> {
 public:
  GeometryRef() = default;
  explicit GeometryRef(wend_ref ref) noexcept : Ref(ref, WEND_GEOMETRY2D) {}
  void poses(Rows rows, std::span<wend_pose> out) const {
    check(table_->poses(self_, rows.data(), static_cast<std::uint32_t>(rows.size()), out.data()));
  }
  void bodies(Rows rows, std::span<wend_disc> body, std::span<wend_disc> goal) const {
    check(table_->bodies(self_, rows.data(), static_cast<std::uint32_t>(rows.size()), body.data(), goal.data()));
  }
  void cast(Rows rows, std::span<const wend_pose> rays, double reach, std::uint32_t kinds, double* distance,
            std::uint8_t* kind) const {
    check(table_->cast(self_, rows.data(), rays.data(), static_cast<std::uint32_t>(rays.size()), reach, kinds, distance, kind));
  }
  void clearance(Rows rows, std::span<const double> xy, std::uint32_t kinds, std::span<double> out) const {
    check(table_->clearance(self_, rows.data(), xy.data(), static_cast<std::uint32_t>(rows.size()), kinds, out.data()));
  }
  std::span<const wend_shape> shapes(std::uint32_t copy) const {
    const wend_shape* first = nullptr;
    std::uint32_t n = 0;
    check(table_->shapes(self_, copy, &first, &n));
    return {first, n};
  }
};

}  // namespace wend
