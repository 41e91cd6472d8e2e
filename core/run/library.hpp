// Plugins loaded into this process.  Only workers do this (and the host with --isolation=none).
#pragma once
#include <wend/abi.h>

#include <map>
#include <memory>
#include <string>

namespace wend::core {

class Libraries {
 public:
  Libraries();
  ~Libraries();

  // Component id -> absolute path of the shared object that has it, from now on.
  void know(std::map<std::string, std::string> files) { files_ = std::move(files); }

  // Loads the file at the first use; throws UnitFailed("load") with the file, what was expected and what was found.
  const wend_component& component(const std::string& id);

 private:
  struct Loaded;
  std::map<std::string, std::string> files_;
  std::map<std::string, std::unique_ptr<Loaded>> loaded_;  // by path
};

}  // namespace wend::core
