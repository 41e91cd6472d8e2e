#include "progress.hpp"

#include <unistd.h>

#include <algorithm>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace wend::app {
namespace {

constexpr double redraw_s = 0.2, plain_s = 10;

std::string rate(double per_second) {
  char text[32];
  if (per_second >= 1e6) std::snprintf(text, sizeof text, "%.1fM", per_second / 1e6);
  else if (per_second >= 1e3) std::snprintf(text, sizeof text, "%.1fk", per_second / 1e3);
  else std::snprintf(text, sizeof text, "%.0f", per_second);
  return text;
}

std::string clock(double seconds) {
  const auto s = static_cast<long>(std::ceil(seconds));
  char text[32];
  if (s >= 3600) std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
  else std::snprintf(text, sizeof text, "%ld:%02ld", s / 60, s % 60);
  return text;
}

core::Json to_json(const core::Progress& p) {
  return {{"cells", {{"planned", p.planned}, {"done", p.done}, {"failed", p.failed}}},
          {"trainings", {{"planned", p.trainings}, {"done", p.trainings_done}}}, {"steps", p.steps}, {"seconds", p.seconds}};
}

}  // namespace

ProgressReport::ProgressReport(bool json) : json_(json), terminal_(isatty(2) == 1), colour_(terminal_ && !std::getenv("NO_COLOR")) {}

std::string ProgressReport::line(const core::Progress& p) const {
  const std::string dot = " \u00b7 ";
  std::string text;
  if (p.trainings) text += "trainings " + std::to_string(p.trainings_done) + "/" + std::to_string(p.trainings) + dot;
  text += "cells " + std::to_string(p.done + p.failed) + "/" + std::to_string(p.planned);
  if (p.seconds > 0.5 && p.steps) text += dot + rate(static_cast<double>(p.steps) / p.seconds) + " steps/s";
  const std::uint64_t fresh = p.done + p.failed - std::min(p.resumed, p.done + p.failed);
  const std::uint64_t left = p.planned - p.done - p.failed;
  if (fresh && left && p.seconds > 1) text += dot + "ETA " + clock(p.seconds / static_cast<double>(fresh) * static_cast<double>(left));
  if (p.failed) text += dot + (colour_ ? "\033[31m" : "") + "failed " + std::to_string(p.failed) + (colour_ ? "\033[0m" : "");
  return text;
}

void ProgressReport::clear() {
  if (drawn_) std::cerr << "\r\033[K";
  drawn_ = false;
}

void ProgressReport::show(const core::Progress& now) {
  if (now.seconds - last_ < (terminal_ && !json_ ? redraw_s : plain_s) && last_ >= 0) return;
  const bool first = last_ < 0;
  last_ = now.seconds;
  if (json_) {
    std::cerr << core::Json{{"progress", to_json(now)}}.dump() << "\n";
  } else if (terminal_) {
    clear();
    std::cerr << line(now) << std::flush;
    drawn_ = true;
  } else if (!first) {
    std::cerr << line(now) << "\n";
  }
}

void ProgressReport::tell(const core::RunFailure& failure) {
  if (json_) {
    std::cerr << core::Json{{"failure", {{"unit", failure.unit}, {"what", failure.what}, {"cause", failure.failure.cause}, {"message", failure.failure.message}}}}.dump() << "\n";
    return;
  }
  clear();
  std::cerr << "failed " << failure.unit << " " << failure.what << "\n  " << failure.failure.cause << ": " << failure.failure.message << "\n";
}

void ProgressReport::end(const core::RunReport& report) {
  clear();
  if (json_) {
    std::cerr << core::Json{{"progress", to_json(report.progress)}, {"stopped", report.stopped}}.dump() << "\n";
    return;
  }
  for (const std::string& warning : report.warnings) std::cerr << "warning: " << warning << "\n";
  std::cerr << line(report.progress);
  if (report.progress.resumed) std::cerr << " \u00b7 " << report.progress.resumed << " were there already";
  std::cerr << " \u00b7 " << clock(report.progress.seconds) << (report.stopped ? " \u00b7 stopped; run it again to go on" : "") << "\n";
}

}  // namespace wend::app
