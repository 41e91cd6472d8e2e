// wend: one program, a subcommand for everything.
#include "command.hpp"

#include <core/run/build_id.hpp>
#include <wend/abi.h>

#include <cstdio>
#include <functional>
#include <iostream>
#include <map>

namespace wend::app {
namespace {

constexpr const char* overview = R"(wend: experiments on learning mobile-robot navigation, composed from plugins.

usage: wend COMMAND [OPTIONS]

  run EXPERIMENT --out DIR   run an experiment; on the same DIR it goes on where it stopped
  validate EXPERIMENT        check an experiment file and create everything it names, without running it
  status DIR                 what is done, what failed and why
  render DIR                 make the pictures of a run again
  explain DIR --arm ID       what a policy says of itself: its rules, why it decided so
  plugins list|show          what is installed, what its parameters are
  worlds list|show|import    worlds, their scenes, other people's maps
  new plugin NAME            a plugin of your own, ready to build
  version

wend COMMAND --help tells more.
)";

int show_version(const Arguments& arguments) {
  po::options_description options;
  options.add_options()("json", "machine-readable output");
  const auto values = parse(arguments, "version [--json]", "The version of wend and of its plugin interface.", options, {});
  const std::string abi = std::to_string(WEND_ABI_MAJOR) + "." + std::to_string(WEND_ABI_MINOR);
  if (values.count("json")) std::cout << Json{{"wend", core::version}, {"abi", abi}}.dump() << "\n";
  else std::cout << "wend " << core::version << " (plugin ABI " << abi << ")\n";
  return 0;
}

int dispatch(const Arguments& all) {
  static const std::map<std::string, std::function<int(const Arguments&)>> commands = {
      {"run", run},         {"validate", validate}, {"status", status},   {"render", render},
      {"explain", explain},
      {"plugins", plugins}, {"worlds", worlds},     {"new", new_plugin}, {"version", show_version}};
  if (all.empty() || all.front() == "--help" || all.front() == "-h" || all.front() == "help") {
    std::cout << overview;
    return all.empty() ? static_cast<int>(Exit::usage) : 0;
  }
  const std::string name = all.front() == "--version" ? "version" : all.front();
  const auto command = commands.find(name);
  if (command == commands.end()) {
    std::vector<std::string> names;
    for (const auto& [known, function] : commands) names.push_back(known);
    const std::string near = core::did_you_mean(name, names);
    throw Usage("unknown command \"" + name + "\"" + (near.empty() ? "" : ": did you mean \"" + near + "\"?") + "\nwend --help lists the commands");
  }
  return command->second(Arguments(all.begin() + 1, all.end()));
}

int guarded(const Arguments& arguments) {
  try {
    return dispatch(arguments);
  } catch (const HelpShown&) {
    return 0;
  } catch (const Stopped& stopped) {
    return static_cast<int>(stopped.exit);
  } catch (const core::Error& error) {
    std::cerr << "error: " << error.what() << "\n";
    return static_cast<int>(error.exit());
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << "\n";
    return static_cast<int>(Exit::data);
  }
}

}  // namespace
}  // namespace wend::app

int main(int argc, char** argv) { return wend::app::guarded({argv + 1, argv + argc}); }
