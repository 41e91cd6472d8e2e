// wend-render: display lists in, PNG files out.  One JSON line a picture on stdin, {"out": "a.png", "scale": 2,
// "figure": {...}}; one JSON line an answer on stdout, {"out": "a.png", "ok": true}.  Never opens a window.
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/base/json.hpp>
#include <cstdio>
#include <exception>
#include <opencv2/core/utility.hpp>
#include <optional>
#include <string>

#include "paint.hpp"

namespace {

using wend::core::Error;
using wend::core::Exit;
using wend::core::Json;

constexpr std::size_t longest_line = std::size_t{1} << 29;

constexpr const char* usage =
    "usage: wend-render < PICTURES\n"
    "Reads one JSON line a picture, {\"out\": \"a.png\", \"scale\": 2, \"figure\": {...}}, writes the PNG files\n"
    "and answers one JSON line each.  Exit codes: 0 all written, 2 usage, 5 a picture was not written.\n"
    "WEND_FONTS=DIR: the folder with DejaVuSans.ttf, if it is in none of the usual ones.\n";

enum class Line { read, too_long, none };

Line read_line(std::string& line) {
  line.clear();
  bool whole = true;
  for (int c = std::getc(stdin); c != EOF; c = std::getc(stdin)) {
    if (c == '\n') return whole ? Line::read : Line::too_long;
    if (line.size() < longest_line)
      line.push_back(static_cast<char>(c));
    else
      whole = false;
  }
  if (line.empty()) return Line::none;
  return whole ? Line::read : Line::too_long;
}

void draw(const Json& job, std::string& out, std::optional<wend::render::Fonts>& fonts) {
  if (!job.is_object() || !job.contains("out") || !job["out"].is_string() ||
      job["out"].get_ref<const std::string&>().empty())
    throw Error(Exit::data, "expected an object with the path \"out\"");
  out = job["out"].get<std::string>();
  for (const auto& entry : job.items())
    if (entry.key() != "out" && entry.key() != "scale" && entry.key() != "figure")
      throw Error(Exit::data, "unknown key \"" + entry.key() + "\"");
  if (!job.contains("scale") || !job["scale"].is_number() || !(job["scale"] >= 0.1 && job["scale"] <= 10))
    throw Error(Exit::data, "scale: expected a number in [0.1, 10]");
  if (!job.contains("figure")) throw Error(Exit::data, "expected an object with \"figure\"");
  const wend::core::Figure figure = wend::core::figure_from_json(job["figure"]);
  if (!fonts) fonts.emplace();
  const auto png = wend::render::paint(figure, job["scale"].get<double>(), *fonts).png();
  wend::core::write_file(out, {reinterpret_cast<const char*>(png.data()), png.size()});
}

bool answer(const std::string& line, Line state, std::optional<wend::render::Fonts>& fonts) {
  std::string out, error;
  try {
    if (state == Line::too_long) throw Error(Exit::data, "a line is longer than 512 MB");
    draw(Json::parse(line), out, fonts);
  } catch (const Json::parse_error& e) {
    error = std::string("not JSON: ") + e.what();
  } catch (const std::exception& e) {
    error = e.what();
  }
  Json reply = {{"out", out}, {"ok", error.empty()}};
  if (!error.empty()) reply["error"] = error;
  std::puts(reply.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
  std::fflush(stdout);
  return error.empty();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) {
    const bool help = std::string(argv[1]) == "--help" && argc == 2;
    std::fputs(usage, help ? stdout : stderr);
    return help ? 0 : static_cast<int>(Exit::usage);
  }
  cv::setNumThreads(1);
  std::optional<wend::render::Fonts> fonts;
  bool all_written = true;
  std::string line;
  for (Line state = read_line(line); state != Line::none; state = read_line(line))
    all_written = answer(line, state, fonts) && all_written;
  return std::ferror(stdin) != 0 || std::ferror(stdout) != 0 || !all_written ? static_cast<int>(Exit::data) : 0;
}
