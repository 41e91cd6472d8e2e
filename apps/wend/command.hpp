// The subcommands of wend and what they share.
#pragma once
#include <core/base/diagnostics.hpp>
#include <core/base/error.hpp>
#include <core/experiment/experiment.hpp>
#include <core/plugin/catalog.hpp>
#include <core/run/work.hpp>

#include <boost/program_options.hpp>

#include <string>
#include <vector>

namespace wend::app {

namespace po = boost::program_options;
using core::Exit;
using core::Json;

using Arguments = std::vector<std::string>;

// Each takes the arguments behind its name and returns the exit code; errors are thrown.
int run(const Arguments& arguments);
int validate(const Arguments& arguments);
int status(const Arguments& arguments);
int render(const Arguments& arguments);
int explain(const Arguments& arguments);
int plugins(const Arguments& arguments);
int worlds(const Arguments& arguments);
int new_plugin(const Arguments& arguments);

// Wrong usage: told with the command's own help line.
class Usage : public core::Error {
 public:
  using core::Error::Error;
  explicit Usage(const std::string& message) : core::Error(Exit::usage, message) {}
};

// --help was asked for; it has been printed.
struct HelpShown {};

// Parses `arguments`; positional names get one each, the last one all that is left.  Prints help and throws HelpShown.
po::variables_map parse(const Arguments& arguments, const std::string& usage, const std::string& about, const po::options_description& options,
                        const std::vector<std::string>& positional);

// --plugin-path and --json, which most commands have.
void add_common(po::options_description& options);
core::Catalog catalog_of(const po::variables_map& values);

// The experiment options of run and validate: --set, --only, --seeds.
void add_experiment_options(po::options_description& options);
core::Options experiment_options(const po::variables_map& values);

// Loads it, or prints every diagnostic and throws Stopped.
core::Experiment load(const std::string& path, const core::Catalog& catalog, const po::variables_map& values);
struct Stopped {
  Exit exit;
};

// A folder that belongs to wend: "share/wend/template" beside the program, in the build tree and when installed.
std::string share_directory(const std::string& name);
std::string worker_path();

// The result of one request, done in a worker of its own; throws Error with the reason where it failed.
Json ask_worker(core::Request request);

}  // namespace wend::app
