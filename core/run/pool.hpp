// Worker processes: a request goes to an idle one; whatever kills a worker fails that request alone, with its cause.
#pragma once
#include <chrono>
#include <core/run/work.hpp>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

struct PoolOptions {
  std::uint32_t jobs = 1;
  std::string worker;                   // path of wend-worker
  std::string logs;                     // folder for the workers' stdout and stderr
  std::chrono::seconds deadline{3600};  // wall time of one request
  std::uint64_t memory = std::uint64_t{8} << 30;
  std::uint32_t requests_per_worker = 1000;  // then a fresh process
  bool isolated = true;                      // false: in this process, for debugging and profiling
};

struct Completion {
  std::string id;
  Answer answer;
};

class Pool {
 public:
  explicit Pool(PoolOptions options);
  ~Pool();

  void submit(std::string id, Request request) { queue_.push_back({std::move(id), std::move(request)}); }
  // A finished request, or nothing after `wait`, or earlier where a signal came.
  std::optional<Completion> next(std::chrono::milliseconds wait);
  std::size_t pending() const noexcept;  // queued or running
  // Drops what is queued; what runs goes on.
  void drop_queue() { queue_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;
  struct Item {
    std::string id;
    Request request;
    bool fresh = false;  // only a worker that served nobody else may do it
  };
  struct Worker;

  void dispatch();
  void start(Worker& worker);
  bool listen(Clock::time_point until);
  void receive(Worker& worker);
  void expire(Worker& worker);
  void died(Worker& worker, const std::string& note);
  void finish(Worker& worker, Answer answer);

  PoolOptions options_;
  std::deque<Item> queue_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::deque<Completion> done_;
  std::unique_ptr<Libraries> own_;  // when not isolated
};

}  // namespace wend::core
