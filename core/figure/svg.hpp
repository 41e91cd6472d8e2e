// The display list as SVG text, for reports and papers.
#pragma once
#include <core/figure/display.hpp>
#include <string>
#include <string_view>

namespace wend::core {

// Text as it may stand in XML, in content and in attributes: markup is escaped, what XML cannot hold becomes U+FFFD.
std::string xml_text(std::string_view text);

// One <svg> element.  `id` begins the names of its clip paths; give each figure of a page its own.
std::string to_svg(const Figure& figure, const std::string& id = "figure");

}  // namespace wend::core
