// wend/error.hpp -- errors of C++ plugins, and the line that no exception crosses.
#pragma once
#include <wend/abi.h>

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace wend {

// What a plugin throws.  The message says what was expected and what was found; `parameter` is the path of the parameter
// at fault ("axes_deg/2"), or empty.
class Error : public std::runtime_error {
 public:
  Error(wend_status code, std::string parameter, const std::string& message)
      : std::runtime_error(message), code_(code), parameter_(std::move(parameter)) {}
  explicit Error(const std::string& message) : Error(WEND_E_INTERNAL, {}, message) {}

  wend_status code() const noexcept { return code_; }
  const std::string& parameter() const noexcept { return parameter_; }

 private:
  wend_status code_;
  std::string parameter_;
};

inline Error parameter_error(std::string parameter, const std::string& message) {
  return Error(WEND_E_PARAMETER, std::move(parameter), message);
}
inline Error unsupported(const std::string& message) { return Error(WEND_E_UNSUPPORTED, {}, message); }
inline Error damaged_state(const std::string& message) { return Error(WEND_E_STATE, {}, message); }

// Thrown where a call of another component failed: that component has already told the host why.
struct Failed {
  wend_status code;
};

inline void check(wend_status status) {
  if (status != WEND_OK) throw Failed{status};
}

// A number as a message tells it: "300", "0.25", "1e-09".
inline std::string number_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", number);
  return text;
}

// Runs `body` and turns whatever it throws into a status.
template <class Body>
wend_status guarded(const wend_host* host, Body&& body) noexcept {
  try {
    body();
    return WEND_OK;
  } catch (const Failed& failed) {
    return failed.code;
  } catch (const Error& error) {
    return host->fail(host, error.code(), error.parameter().empty() ? nullptr : error.parameter().c_str(), error.what());
  } catch (const std::bad_alloc&) {
    return host->fail(host, WEND_E_INTERNAL, nullptr, "out of memory");
  } catch (const std::exception& error) {
    return host->fail(host, WEND_E_INTERNAL, nullptr, error.what());
  } catch (...) {
    return host->fail(host, WEND_E_INTERNAL, nullptr, "an exception that is not a std::exception");
  }
}

}  // namespace wend
