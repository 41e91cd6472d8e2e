#include "command.hpp"

#include <core/base/files.hpp>
#include <core/run/pool.hpp>

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace wend::app {

po::variables_map parse(const Arguments& arguments, const std::string& usage, const std::string& about, const po::options_description& options,
                        const std::vector<std::string>& positional) {
  po::options_description all;
  all.add(options);
  all.add_options()("help,h", "this text");
  po::positional_options_description places;
  for (std::size_t i = 0; i < positional.size(); ++i) {
    all.add_options()(positional[i].c_str(), po::value<std::vector<std::string>>());
    places.add(positional[i].c_str(), i + 1 == positional.size() ? -1 : 1);
  }
  po::variables_map values;
  try {
    using namespace po::command_line_style;
    const int style = unix_style & ~allow_guessing;  // or --see 4 would be --seeds 4
    po::store(po::command_line_parser(arguments).options(all).positional(places).style(style).run(), values);
    po::notify(values);
  } catch (const po::error& error) {
    throw Usage(std::string(error.what()) + "\nusage: wend " + usage);
  }
  if (values.count("help")) {
    po::options_description shown;
    shown.add(options);
    shown.add_options()("help,h", "this text");
    std::cout << "usage: wend " << usage << "\n\n" << about << "\n" << shown;
    throw HelpShown{};
  }
  return values;
}

void add_common(po::options_description& options) {
  options.add_options()("plugin-path", po::value<std::vector<std::string>>()->value_name("DIR|FILE"), "look for plugins here first; may be given several times")(
      "json", "machine-readable output");
}

core::Catalog catalog_of(const po::variables_map& values) {
  const auto given = values.count("plugin-path") ? values["plugin-path"].as<std::vector<std::string>>() : std::vector<std::string>{};
  return core::Catalog::search(core::search_path(given));
}

void add_experiment_options(po::options_description& options) {
  options.add_options()("set", po::value<std::vector<std::string>>()->value_name("/POINTER=VALUE"), "change a value of the experiment file")(
      "only", po::value<std::string>()->value_name("arm=A,world=W"), "run these arms and worlds only")(
      "seeds", po::value<std::string>()->value_name("A:B"), "run the seeds from A up to but not B only");
}

namespace {

// The environment, and WEND_DATA beside the checkout that the program was built in where it is not set.
std::map<std::string, std::string> variables() {
  std::map<std::string, std::string> all;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    if (const std::size_t equals = text.find('='); equals != std::string::npos) all[text.substr(0, equals)] = text.substr(equals + 1);
  }
  all.try_emplace("WEND_DATA", (std::filesystem::path(core::program_directory()) / "../../../shared/data").lexically_normal().string());
  return all;
}

}  // namespace

core::Options experiment_options(const po::variables_map& values) {
  core::Options options;
  options.variables = variables();
  if (values.count("set")) options.set = values["set"].as<std::vector<std::string>>();
  if (values.count("only")) {
    const std::string text = values["only"].as<std::string>();
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(',', from), text.size());
      options.only.push_back(text.substr(from, to - from));
      from = to + 1;
    }
  }
  if (values.count("seeds")) {
    const std::string text = values["seeds"].as<std::string>();
    const std::size_t colon = text.find(':');
    char* end = nullptr;
    const std::uint64_t first = std::strtoull(text.c_str(), &end, 10);
    const bool good = colon != std::string::npos && colon > 0 && *end == ':' && colon + 1 < text.size();
    const std::uint64_t last = good ? std::strtoull(text.c_str() + colon + 1, &end, 10) : 0;
    if (!good || *end != '\0' || text.find('-') != std::string::npos || last <= first)
      throw Usage("--seeds: expected A:B with A below B, such as 0:10, found \"" + text + "\"");
    options.seeds = {first, last};
  }
  return options;
}

core::Experiment load(const std::string& path, const core::Catalog& catalog, const po::variables_map& values) {
  core::Diagnostics diagnostics;
  auto experiment = core::load_experiment(path, catalog, experiment_options(values), diagnostics);
  if (experiment && !diagnostics.any()) return std::move(*experiment);
  if (values.count("json")) {
    std::cout << Json{{"ok", false}, {"errors", diagnostics.json()}}.dump(2) << "\n";
  } else {
    std::cerr << diagnostics.text();
    std::cerr << diagnostics.size() << (diagnostics.size() == 1 ? " error" : " errors") << " in " << path << "\n";
  }
  throw Stopped{Exit::configuration};
}

std::string share_directory(const std::string& name) {
  const std::string directory = std::filesystem::path(core::program_directory()).parent_path() / "share" / "wend" / name;
  if (!std::filesystem::is_directory(directory))
    throw core::Error(Exit::data, "expected the folder " + directory + " beside the program, found none: is wend installed whole?");
  return directory;
}

std::string worker_path() {
  const std::string directory = core::program_directory();
  for (const std::string& path : {directory + "/wend-worker", directory + "/../libexec/wend/wend-worker"})
    if (::access(path.c_str(), X_OK) == 0) return path;
  throw core::Error(Exit::data, "expected wend-worker in " + directory + ", found none: is wend installed whole?");
}

Json ask_worker(core::Request request) {
  const std::string scratch = std::filesystem::temp_directory_path() / ("wend-ask-" + std::to_string(::getpid()));
  core::make_directories(scratch);
  request.scratch = scratch;
  core::PoolOptions options;
  options.worker = worker_path();
  options.logs = scratch;
  core::Answer answer;
  answer.failure = {"timeout", "a worker was asked and gave no answer within 2 minutes"};
  {
    core::Pool pool(options);
    pool.submit("question", std::move(request));
    if (const auto completion = pool.next(std::chrono::minutes(2))) answer = completion->answer;
  }
  std::error_code ignored;
  std::filesystem::remove_all(scratch, ignored);
  const std::string& cause = answer.failure.cause;
  if (!answer.ok) throw core::Error(cause == "plugin" || cause == "state" ? Exit::data : Exit::plugin, answer.failure.message);
  return answer.result;
}

}  // namespace wend::app
