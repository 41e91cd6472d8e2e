#include <algorithm>
#include <cmath>
#include <core/figure/svg.hpp>
#include <core/figure/text_metrics.hpp>
#include <cstdio>

namespace wend::core {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", std::isfinite(value) ? value : 0.0);
  std::string result = text;
  while (result.back() == '0') result.pop_back();
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

// Appended piece by piece: g++ 12 warns of its own operator+ here.
template <class... Parts>
std::string joined(const Parts&... parts) {
  std::string text;
  (text.append(parts), ...);
  return text;
}

void attribute(std::string& out, const char* name, const std::string& value) {
  out.append(" ").append(name).append("=\"").append(value).append("\"");
}
void attribute(std::string& out, const char* name, double value) {
  attribute(out, name, number(value));
}

void colour(std::string& out, const std::string& name, const Colour& c) {
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c.red, c.green, c.blue);
  attribute(out, name.c_str(), text);
  if (c.alpha != 255) attribute(out, joined(name, "-opacity").c_str(), c.alpha / 255.0);
}

template <class Shape>
void look(std::string& out, const Shape& shape) {
  if (shape.fill)
    colour(out, "fill", *shape.fill);
  else
    attribute(out, "fill", std::string("none"));
  if (!shape.pen) return;
  const Pen& pen = *shape.pen;
  colour(out, "stroke", pen.colour);
  attribute(out, "stroke-width", pen.width);
  attribute(out, "stroke-linejoin", std::string("round"));
  if (pen.cap == Cap::round) attribute(out, "stroke-linecap", std::string("round"));
  std::string dash;
  for (const double length : pen.dash) dash.append(dash.empty() ? "" : " ").append(number(length));
  if (!dash.empty()) attribute(out, "stroke-dasharray", dash);
}

struct Writer {
  std::string& out;

  void operator()(const Path& path) const {
    std::string d;
    for (const Place& p : path.points)
      d.append(d.empty() ? "M" : "L").append(number(p.x)).append(" ").append(number(p.y));
    if (path.closed && !d.empty()) d += "Z";
    out += "<path";
    attribute(out, "d", d);
    if (path.fill) attribute(out, "fill-rule", std::string("evenodd"));
    look(out, path);
    out += "/>";
  }
  void operator()(const Circle& circle) const {
    out += "<circle";
    attribute(out, "cx", circle.centre.x);
    attribute(out, "cy", circle.centre.y);
    attribute(out, "r", circle.radius);
    look(out, circle);
    out += "/>";
  }
  void operator()(const Rectangle& rectangle) const {
    out += "<rect";
    box(rectangle.box);
    look(out, rectangle);
    out += "/>";
  }
  void operator()(const Text& text) const {
    static const char* const anchors[] = {"start", "middle", "end"};
    out += "<text";
    attribute(out, "x", text.at.x);
    attribute(out, "y", text.at.y);
    attribute(out, "font-size", text.size);
    colour(out, "fill", text.colour);
    if (text.anchor != Anchor::start)
      attribute(out, "text-anchor", std::string(anchors[static_cast<int>(text.anchor)]));
    if (text.bold) attribute(out, "font-weight", std::string("bold"));
    if (text.turn != 0)
      attribute(out, "transform",
                joined("rotate(", number(text.turn), " ", number(text.at.x), " ", number(text.at.y), ")"));
    if (text.halo > 0) {
      attribute(out, "stroke", std::string("#ffffff"));
      attribute(out, "stroke-width", 2 * text.halo);
      attribute(out, "stroke-linejoin", std::string("round"));
      attribute(out, "paint-order", std::string("stroke"));
    }
    out.append(">").append(xml_text(text.text)).append("</text>");
  }
  // Each run of filled cells is a rectangle of one path.
  void operator()(const Cells& cells) const {
    const double w = cells.box.width / std::max(1u, cells.columns), h = cells.box.height / std::max(1u, cells.rows);
    std::string d;
    for (std::uint32_t row = 0; row < cells.rows; ++row) {
      const std::uint8_t* line = cells.cells.data() + static_cast<std::size_t>(row) * cells.columns;
      for (std::uint32_t from = 0; from < cells.columns; ++from) {
        if (line[from] == 0) continue;
        std::uint32_t to = from;
        while (to < cells.columns && line[to] != 0) ++to;
        const double run = (to - from) * w;
        d += joined("M", number(cells.box.x + from * w), " ", number(cells.box.y + row * h), "h", number(run), "v",
                    number(h), "h", number(-run), "z");
        from = to;
      }
    }
    out += "<path shape-rendering=\"crispEdges\"";
    attribute(out, "d", d);
    colour(out, "fill", cells.fill);
    out += "/>";
  }
  void box(const Box& b) const {
    attribute(out, "x", b.x);
    attribute(out, "y", b.y);
    attribute(out, "width", b.width);
    attribute(out, "height", b.height);
  }
};

}  // namespace

std::string xml_text(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t start = i;
    const char32_t point = next_code_point(text, i);
    const bool legal = (point >= 0x20 || point == '\t' || point == '\n') && point != 0xFFFE && point != 0xFFFF;
    if (!legal || point == 0xFFFD)
      out += "\xEF\xBF\xBD";
    else if (point == '&')
      out += "&amp;";
    else if (point == '<')
      out += "&lt;";
    else if (point == '>')
      out += "&gt;";
    else if (point == '"')
      out += "&quot;";
    else if (point == '\'')
      out += "&#39;";
    else
      out.append(text.substr(start, i - start));
  }
  return out;
}

std::string to_svg(const Figure& figure, const std::string& id) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"";
  attribute(out, "width", figure.width);
  attribute(out, "height", figure.height);
  attribute(out, "viewBox", joined("0 0 ", number(figure.width), " ", number(figure.height)));
  attribute(out, "font-family", std::string("DejaVu Sans, Verdana, sans-serif"));
  out += joined("><title>", xml_text(figure.title), "</title>");
  const Writer writer{out};
  for (std::size_t i = 0; i < figure.clips.size(); ++i) {
    out += "<clipPath";
    attribute(out, "id", joined(xml_text(id), "-clip", std::to_string(i)));
    out += "><rect";
    writer.box(figure.clips[i]);
    out += "/></clipPath>";
  }
  out += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  std::int32_t open = -1;  // items of one clip in a row share a group
  for (const Item& item : figure.items) {
    if (item.clip != open && open >= 0) out += "</g>";
    if (item.clip != open && item.clip >= 0)
      out += joined("<g clip-path=\"url(#", xml_text(id), "-clip", std::to_string(item.clip), ")\">");
    open = item.clip;
    std::visit(writer, item.what);
    out += "\n";
  }
  if (open >= 0) out += "</g>";
  return out + "</svg>\n";
}

}  // namespace wend::core
