// One policy for each thing that no plugin should do, in C against the bare ABI: nothing is caught on the way to the
// host.
#include <fcntl.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>
#include <wend/abi.h>

#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

struct wend_object {
  const wend_host* host;
  std::string deed, when, scratch;
  long at = 2, decisions = 0;
};

namespace {

[[gnu::noinline]] int deep(int n) {
  volatile char frame[4096];
  frame[0] = static_cast<char>(n);
  return n < 0 ? 0 : deep(n + 1) + frame[0];
}

void to_every_descriptor(const char* bytes, std::size_t n) {
  for (int fd = 3; fd < 1024; ++fd)
    if (::send(fd, bytes, n, MSG_NOSIGNAL) < 0) [[maybe_unused]]
      const auto ignored = ::write(fd, bytes, n);
}

void close_all() {
  for (int fd = 0; fd < 1024; ++fd) ::close(fd);
}

[[noreturn]] void forever() {
  for (volatile bool on = true; on;) {
  }
  std::abort();
}

[[noreturn]] void deaf_forever() {
  for (int signal = 1; signal < 32; ++signal) std::signal(signal, SIG_IGN);
  forever();
}

void* crash_later(void*) {
  usleep(150000);
  std::abort();
}

void* garbage_later(void*) {
  usleep(150000);
  to_every_descriptor("late", 4);
  while (true) pause();
}

void later(void* (*what)(void*)) {
  pthread_t thread;
  pthread_create(&thread, nullptr, what, nullptr);
  pthread_detach(thread);
}

void print(std::size_t bytes) {
  const std::string line(1 << 20, 'x');
  for (std::size_t done = 0; done < bytes; done += line.size())
    [[maybe_unused]] const auto ignored = ::write(1, line.data(), line.size());
}

void write_file_beyond_the_limit(const std::string& path) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT, 0666);
  ::lseek(fd, off_t{3} << 30, SEEK_SET);
  [[maybe_unused]] const auto ignored = ::write(fd, "x", 1);
  ::close(fd);
}

void remove_all_in(const std::string& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".npz") std::filesystem::remove(entry.path());
}

void child_that_stays() {
  if (fork() == 0) {
    alarm(20);  // should the host not end it
    while (true) pause();
  }
  std::abort();
}

void commit(const std::string& deed, const std::string& scratch) {
  if (volatile std::uintptr_t nowhere = 8; deed == "segv") *reinterpret_cast<volatile int*>(nowhere) = 1;
  if (deed == "abort") std::abort();
  if (deed == "throw") throw std::runtime_error("thrown across");
  if (deed == "throw_int") throw 42;
  if (deed == "exit") std::exit(0);
  if (deed == "_exit") _exit(0);
  if (deed == "exit_7") _exit(7);
  if (deed == "loop") forever();
  if (deed == "deaf_loop") deaf_forever();
  if (deed == "bad_alloc") throw std::bad_alloc();
  if (deed == "reserve") {
    for (std::vector<void*> blocks;;) blocks.push_back(::operator new (std::size_t{1} << 30));
  }
  if (deed == "stack") std::exit(deep(0));
  if (deed == "garbage") to_every_descriptor("this is forty bytes that are not a frame", 40);
  if (deed == "short_garbage") to_every_descriptor("hi", 2);
  if (deed == "garbage_later") later(garbage_later);
  if (deed == "crash_later") later(crash_later);
  if (deed == "close") close_all();
  if (deed == "close_and_loop") close_all(), forever();
  if (deed == "print") print(std::size_t{100} << 20);
  if (deed == "last_words") std::fprintf(stderr, "%s\nI am dying\n", std::string(1000, '.').c_str()), std::abort();
  if (deed == "rounding") std::fesetround(FE_UPWARD);
  if (deed == "flush") __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040u);
  if (deed == "locale") std::setlocale(LC_ALL, "C.UTF-8");
  if (deed == "chdir") [[maybe_unused]]
    const auto ignored = ::chdir("/");
  if (deed == "double_free") {
    void* volatile block = std::malloc(64);
    std::free(block);
    std::free(block);
  }
  if (deed == "big_file") write_file_beyond_the_limit(scratch);
  if (deed == "unlink") remove_all_in(scratch);
  if (deed == "child") child_that_stays();
  if (deed == "kill_group" && ::getpgrp() == ::getpid())
    ::kill(0, SIGKILL);  // the host is to have given it a group of its own
}

wend_status act(wend_object* self, const std::uint32_t*, std::uint32_t n, const double*, double* actions) {
  if (self->when == "act" && self->decisions++ == self->at) commit(self->deed, self->scratch);
  for (std::uint32_t i = 0; i < n; ++i) actions[i] = 1;
  return WEND_OK;
}

constexpr wend_policy policy{sizeof(wend_policy), nullptr, &act};

wend_status create(const wend_host* host, const wend_config* config, wend_object** out) {
  std::map<std::string, const wend_value*> values;
  for (std::uint32_t i = 0; i < config->value_count; ++i) values[config->values[i].path] = &config->values[i];
  auto* self = new wend_object{host, values.at("deed")->text, values.at("when")->text, values.at("scratch")->text};
  self->at = static_cast<long>(values.at("at")->number);
  if (self->when == "create") commit(self->deed, self->scratch);
  *out = self;
  return WEND_OK;
}

void destroy(wend_object* self) {
  if (self->when == "destroy") commit(self->deed, self->scratch);
  delete self;
}

const void* query(wend_object*, const char* id) {
  return std::strcmp(id, WEND_POLICY) == 0 ? &policy : nullptr;
}

constexpr wend_component component{sizeof(wend_component), "bad.policy", &create, &destroy, &query};
constexpr const wend_component* components[] = {&component};

}  // namespace

extern "C" WEND_EXPORT constexpr wend_plugin wend_plugin_1{sizeof(wend_plugin), WEND_ABI_MAJOR, WEND_ABI_MINOR, 1,
                                                           components};
