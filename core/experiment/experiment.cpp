#include <algorithm>
#include <core/base/files.hpp>
#include <core/experiment/experiment.hpp>
#include <core/experiment/pointer.hpp>
#include <filesystem>
#include <sstream>
#include <tuple>

namespace wend::core {

namespace {

constexpr double max_points = 10'000;

struct Dimension {
  std::string key, pointer;  // key: where it stands below "/sweep"
  Json values;
};

class Loader {
 public:
  Loader(Document document, std::string path, const Catalog& catalog, const Options& options, Diagnostics& diagnostics)
      : document_(std::move(document)),
        catalog_(catalog),
        options_(options),
        diagnostics_(diagnostics),
        assets_(std::filesystem::absolute(path).parent_path().string(), options.variables) {
    experiment_.file = std::move(path);
  }

  std::optional<Experiment> load() {
    Json file = document_.root();
    for (const std::string& text : options_.set) set(file, text);
    if (diagnostics_.any()) return std::nullopt;

    const Scope scope{document_, catalog_, assets_, diagnostics_};
    std::optional<Resolved> base = resolve(scope, file);
    const std::vector<Dimension> dimensions = sweep(scope, file, base ? base->file : file);
    if (!base) return std::nullopt;
    read_filter(*base);
    if (diagnostics_.any()) return std::nullopt;
    add_points(file, dimensions);
    if (diagnostics_.any()) return std::nullopt;
    if (experiment_.plan.cell_count() == 0)
      complain("--only leaves nothing to run: no arm that it names is tested in a world that it names");
    if (diagnostics_.any()) return std::nullopt;
    finish(*base);
    return std::move(experiment_);
  }

 private:
  void complain(std::string message, std::string hint = "") {  // of the command line, which has no line and column
    Diagnostic diagnostic;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    diagnostics_.add(std::move(diagnostic));
  }

  // ---------------------------------------------------------------------------------------------------- options

  void set(Json& file, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (text.empty() || text[0] != '/' || equals == std::string::npos)
      return complain("--set " + quote(text) + ": expected /pointer=value", "such as --set /seed=7");
    const std::string pointer = text.substr(0, equals), value = text.substr(equals + 1);
    Diagnostics not_json;
    const std::optional<Document> parsed = Document::parse("--set", value, not_json);
    if (const auto problem = assign(file, pointer, parsed ? parsed->root() : Json(value)))
      return complain("--set " + quote(text) + ": " + *problem);
    document_.replaced(pointer, "--set " + text);
  }

  void read_filter(const Resolved& base) {
    filter_.end_seed = base.seeds;
    if (options_.seeds) {
      std::tie(filter_.first_seed, filter_.end_seed) = *options_.seeds;
      if (filter_.first_seed >= filter_.end_seed)
        complain("--seeds " + std::to_string(filter_.first_seed) + ":" + std::to_string(filter_.end_seed) + " is empty",
                 "the first seed and the one behind the last: 0:10 are ten seeds");
    }
    for (const WorldSpec& world : base.worlds) experiment_.world_ids.push_back(world.id);
    for (const ArmSpec& arm : base.arms) experiment_.arm_ids.push_back(arm.id);
    for (const std::string& only : options_.only) {
      std::istringstream parts(only);
      for (std::string part; std::getline(parts, part, ',');) {
        if (part.starts_with("arm="))
          choose(part.substr(4), "arm", experiment_.arm_ids, filter_.arms);
        else if (part.starts_with("world="))
          choose(part.substr(6), "world", experiment_.world_ids, filter_.worlds);
        else
          complain("--only " + quote(part) + ": expected arm=ID or world=ID", "such as --only arm=a,world=b");
      }
    }
  }

  void choose(const std::string& id, const std::string& what, const std::vector<std::string>& known,
              std::set<std::string>& chosen) {
    chosen.insert(id);
    if (std::find(known.begin(), known.end(), id) != known.end()) return;
    const std::string near = did_you_mean(id, known);
    complain("--only: unknown " + what + " " + quote(id),
             near.empty() ? "expected " + quote_list(known) : "did you mean " + quote(near) + "?");
  }

  // ------------------------------------------------------------------------------------------------------ sweep

  // The dimensions of the sweep in the order of the file, as far as they are usable; `resolved` has the defaults too.
  std::vector<Dimension> sweep(const Scope& scope, const Json& file, const Json& resolved) {
    std::vector<Dimension> dimensions;
    const Json* sweep = member(file, "sweep");
    if (!sweep || !sweep->is_object()) return dimensions;
    double points = 1;
    for (const auto& [pointer, values] : sweep->items()) {
      const std::string key = "/sweep/" + pointer_token(pointer);
      if (!values.is_array() || values.empty()) {
        scope.error(key, "expected the values of " + quote(pointer) + ", found " + quote(values.dump()),
                    "an array of one or more");
        continue;
      }
      if (const auto problem = check_pointer(file, resolved, pointer, values[0])) {
        scope.error(key, "the sweep cannot change " + quote(pointer) + ": " + problem->message, problem->hint, true);
        continue;
      }
      points *= static_cast<double>(values.size());
      dimensions.push_back({key, pointer, values});
    }
    if (points > max_points)
      scope.error("/sweep", "the sweep has more than " + std::to_string(static_cast<int>(max_points)) + " points",
                  "make several experiments of it", true);
    const auto place = [&](const Dimension& dimension) {
      const Diagnostic at = document_.at(dimension.key, "", true);
      return std::pair{at.line, at.column};
    };
    std::stable_sort(dimensions.begin(), dimensions.end(),
                     [&](const Dimension& a, const Dimension& b) { return place(a) < place(b); });
    return dimensions;
  }

  struct Problem {
    std::string message, hint;
  };

  std::optional<Problem> check_pointer(const Json& file, const Json& resolved, const std::string& pointer,
                                       const Json& value) {
    const std::vector<std::string> tokens = pointer_tokens(pointer);
    if (pointer.empty() || pointer[0] != '/') return Problem{"it is no JSON pointer", "such as \"/seed\""};
    if (tokens[0] == "sweep" || tokens[0] == "name" || tokens[0] == "figures" || tokens[0] == "$schema" ||
        tokens[0] == "seeds")
      return Problem{"it is the same at every point",
                     "sweep over parameters, worlds, robots, trainings or the root seed"};
    if (tokens.size() == 3 && tokens[2] == "id")
      return Problem{"tables tell arms and worlds by their ids", "write several arms or worlds"};
    if (is_there(resolved, tokens)) return std::nullopt;
    Json changed = file;
    if (const auto problem = assign(changed, pointer, value))
      return Problem{*problem, "the place of a value in this file"};
    Diagnostics mistakes;  // of a key that is not there and has no default: is it one that may be there?
    resolve({document_, catalog_, assets_, mistakes}, changed);
    for (const Diagnostic& mistake : mistakes.sorted())
      if (mistake.message.starts_with("unknown ") && (pointer + "/").starts_with(mistake.pointer + "/"))
        return Problem{"it hits nothing", mistake.hint};
    return std::nullopt;
  }

  void add_points(const Json& file, const std::vector<Dimension>& dimensions) {
    std::vector<std::size_t> chosen(dimensions.size(), 0);
    for (bool more = true; more && !diagnostics_.full();) {
      Json changed = file, point = Json::object();
      for (std::size_t i = 0; i < dimensions.size(); ++i) {
        const Dimension& dimension = dimensions[i];
        point[dimension.pointer] = dimension.values[chosen[i]];
        if (const auto problem = assign(changed, dimension.pointer, dimension.values[chosen[i]]))
          return diagnostics_.add(document_.at(
              dimension.key, "the sweep cannot change " + quote(dimension.pointer) + ": " + *problem, true));
      }
      if (!add_point(std::move(changed), point, dimensions, chosen)) return;
      more = false;  // the last dimension changes fastest
      for (std::size_t i = dimensions.size(); i-- > 0 && !more;) {
        more = ++chosen[i] < dimensions[i].values.size();
        if (!more) chosen[i] = 0;
      }
    }
  }

  bool add_point(Json file, const Json& point, const std::vector<Dimension>& dimensions,
                 const std::vector<std::size_t>& chosen) {
    Diagnostics mistakes;
    const std::optional<Resolved> resolved = resolve({document_, catalog_, assets_, mistakes}, std::move(file));
    if (!resolved) {
      for (Diagnostic mistake : mistakes.sorted()) diagnostics_.add(blamed(std::move(mistake), dimensions, chosen));
      return true;
    }
    for (const auto& [hash, path] : resolved->state_files) experiment_.state_files[hash] = path;
    experiment_.points.push_back(point);
    if (experiment_.plan.add(point, *resolved, filter_)) return true;
    Diagnostic diagnostic =
        document_.at("", "the experiment has more than " + std::to_string(Plan::max_cells) +
                             " cells (arm x world x variant x seed x snapshot x point of the sweep)");
    diagnostic.hint = "run a part of it with --seeds and --only";
    diagnostics_.add(std::move(diagnostic));
    return false;
  }

  // What a value of the sweep made wrong is reported at that value.
  Diagnostic blamed(Diagnostic mistake, const std::vector<Dimension>& dimensions,
                    const std::vector<std::size_t>& chosen) const {
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
      if (!(mistake.pointer + "/").starts_with(dimensions[i].pointer + "/")) continue;
      Diagnostic here = document_.at(dimensions[i].key + "/" + std::to_string(chosen[i]), mistake.message);
      here.hint = mistake.hint;
      here.notes.insert(here.notes.end(), mistake.notes.begin(), mistake.notes.end());
      return here;
    }
    for (std::size_t i = 0; i < dimensions.size(); ++i)
      mistake.notes.push_back("with " + dimensions[i].pointer + " = " + dimensions[i].values[chosen[i]].dump() +
                              " of the sweep");
    return mistake;
  }

  void finish(Resolved& base) {
    experiment_.name = text_in(base.file, "name");
    if (const Json* figures = member(base.file, "figures")) experiment_.figures = *figures;
    experiment_.resolved = std::move(base.file);
  }

  Document document_;
  const Catalog& catalog_;
  const Options& options_;
  Diagnostics& diagnostics_;
  Assets assets_;
  PlanFilter filter_;
  Experiment experiment_;
};

}  // namespace

std::optional<Experiment> load_experiment(const std::string& path, const Catalog& catalog, const Options& options,
                                          Diagnostics& diagnostics) {
  std::optional<Document> document = Document::parse(path, read_file(path), diagnostics);
  if (!document) return std::nullopt;
  return Loader(std::move(*document), path, catalog, options, diagnostics).load();
}

}  // namespace wend::core
