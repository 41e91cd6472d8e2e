#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <core/run/frame.hpp>
#include <core/run/pool.hpp>
#include <core/run/worker.hpp>
#include <core/run/worker_process.hpp>
#include <cstring>

namespace wend::core {
namespace {

constexpr std::chrono::milliseconds dying{1000};  // longer than a process takes from its last descriptor to its end

Failure failure_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return {"crash", "the worker died of signal " + std::to_string(signal) + " (" + strsignal(signal) + ")"};
  }
  if (WEXITSTATUS(status) == worker_lost_host) return {"protocol", "it closed or disturbed the private descriptor"};
  return {"exit", "the worker left with exit code " + std::to_string(WEXITSTATUS(status)) + " and no answer"};
}

}  // namespace

struct Pool::Worker {
  WorkerProcess process;
  std::string log;
  std::uint32_t served = 0;
  std::string buffer;
  std::optional<Item> item;  // what it works on
  Clock::time_point deadline;
};

Pool::Pool(PoolOptions options) : options_(std::move(options)) {
  if (!options_.isolated) own_ = std::make_unique<Libraries>();
  for (std::uint32_t i = 0; i < std::max(1u, options_.jobs); ++i) {
    workers_.push_back(std::make_unique<Worker>());
    workers_.back()->log = options_.logs + "/worker-" + std::to_string(i) + ".log";
  }
}

Pool::~Pool() = default;  // what runs is killed: an idle worker loses nothing, and none can hold us up at its exit

std::size_t Pool::pending() const noexcept {
  std::size_t n = queue_.size() + done_.size();
  for (const auto& worker : workers_) n += worker->item ? 1 : 0;
  return n;
}

// A process that can take the next request of the queue.
void Pool::start(Worker& worker) {
  const bool spent = worker.served >= options_.requests_per_worker || (queue_.front().fresh && worker.served > 0);
  if (worker.process.running() && (spent || !worker.process.quiet())) worker.process.stop();
  if (worker.process.running()) return worker.process.forget_words();
  worker.process.start(options_.worker, worker.log, options_.memory);
  worker.served = 0;
  worker.buffer.clear();
}

void Pool::dispatch() {
  for (auto& worker : workers_) {
    if (queue_.empty()) return;
    if (worker->item) continue;
    if (!own_) start(*worker);
    Item item = std::move(queue_.front());
    queue_.pop_front();
    if (own_) {
      done_.push_back({item.id, perform(item.request, *own_)});
      return;
    }
    worker->item = std::move(item);
    worker->deadline = Clock::now() + options_.deadline;
    try {
      write_frame(worker->process.fd(), Json(worker->item->request).dump(), worker->process.nonce());
    } catch (const FrameError& error) {
      died(*worker, error.message);
    }
  }
}

std::optional<Completion> Pool::next(std::chrono::milliseconds wait) {
  const auto until = Clock::now() + wait;
  while (true) {
    if (done_.empty()) dispatch();
    if (!done_.empty()) {
      Completion completion = std::move(done_.front());
      done_.pop_front();
      dispatch();  // keep the workers busy while the caller records this one
      return completion;
    }
    if (!listen(until)) return std::nullopt;
  }
}

// Takes in what the workers have to say until then; false where there is nothing more to wait for.
bool Pool::listen(Clock::time_point until) {
  std::vector<pollfd> descriptors;
  std::vector<Worker*> busy;
  auto earliest = until;
  for (auto& worker : workers_) {
    if (!worker->item) continue;
    descriptors.push_back({worker->process.fd(), POLLIN, 0});
    busy.push_back(worker.get());
    earliest = std::min(earliest, worker->deadline);
  }
  if (busy.empty()) return !queue_.empty();
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(earliest - Clock::now()).count();
  const int ready =
      ::poll(descriptors.data(), descriptors.size(), static_cast<int>(std::clamp<long long>(left, 0, 60000)));
  if (ready < 0 && errno == EINTR) return false;  // the caller looks whether it is to stop
  const auto now = Clock::now();
  for (std::size_t i = 0; i < busy.size(); ++i) {
    if (descriptors[i].revents)
      receive(*busy[i]);
    else if (now >= busy[i]->deadline)
      expire(*busy[i]);
    else if (ready == 0 && busy[i]->process.ended({}))
      receive(*busy[i]);  // something it started keeps the descriptor open
  }
  return !done_.empty() || now < until;
}

void Pool::receive(Worker& worker) {
  char bytes[65536];
  const ssize_t n = ::recv(worker.process.fd(), bytes, sizeof bytes, MSG_DONTWAIT);
  if (n < 0 && errno == EINTR) return;
  if (n < 0 && errno == EAGAIN && !worker.process.ended({})) return;
  if (n <= 0) return died(worker, "");
  worker.buffer.append(bytes, static_cast<std::size_t>(n));
  try {
    if (const auto payload = decode_frame(worker.buffer, worker.process.nonce())) {
      if (!worker.buffer.empty()) throw FrameError{"bytes after the answer"};
      finish(worker, Json::parse(*payload).get<Answer>());
    }
  } catch (const FrameError& error) {
    died(worker, "it wrote to the private descriptor: " + error.message);
  } catch (const Json::exception& error) {
    died(worker, std::string("its answer cannot be read: ") + error.what());
  }
}

// Past its deadline.  What is at fault is this request, even in a worker that served others.
void Pool::expire(Worker& worker) {
  Answer answer;
  answer.failure = {
      "timeout", "no answer within " + std::to_string(options_.deadline.count()) + " s" + worker.process.last_words()};
  worker.item->fresh = true;
  worker.process.stop();
  finish(worker, std::move(answer));
}

void Pool::died(Worker& worker, const std::string& note) {
  const bool by_itself = note.empty() && worker.process.ended(dying);  // else it closed its descriptor and goes on
  const std::string words = worker.process.last_words();
  const int status = worker.process.stop();
  Answer answer;
  if (!note.empty())
    answer.failure = {"protocol", note};
  else
    answer.failure =
        by_itself ? failure_of(status) : Failure{"protocol", "it closed or disturbed the private descriptor"};
  answer.failure.message += words;
  finish(worker, std::move(answer));
}

void Pool::finish(Worker& worker, Answer answer) {
  static constexpr const char* of_the_process[] = {"crash", "exit", "protocol", "memory", "host"};
  const auto is = [&](const char* cause) { return answer.failure.cause == cause; };
  Item item = std::move(*worker.item);
  worker.item.reset();
  ++worker.served;
  if (!answer.ok && worker.process.running())
    worker.process.stop();  // what a failed plugin left behind goes with its process
  // A worker that served others may die of what they left: only what happens in a fresh one is this request's own.
  if (!answer.ok && !item.fresh && worker.served > 1 &&
      std::any_of(std::begin(of_the_process), std::end(of_the_process), is)) {
    item.fresh = true;
    queue_.push_front(std::move(item));
    return;
  }
  done_.push_back({std::move(item.id), std::move(answer)});
}

}  // namespace wend::core
