#include "font.hpp"

#include <ft2build.h>

#include <core/base/error.hpp>
#include <core/figure/text_metrics.hpp>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_OUTLINE_H
#include FT_STROKER_H

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace wend::render {
namespace {

using core::Error;
using core::Exit;

constexpr FT_Int32 load_flags = FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP;

void check(FT_Error error, const char* what) {
  if (error != 0) throw Error(Exit::data, std::string("FreeType cannot ") + what + ": error " + std::to_string(error));
}

std::vector<std::string> folders() {
  if (const char* given = std::getenv("WEND_FONTS")) return {given};
  std::vector<std::string> list = {"/usr/share/fonts/truetype/dejavu",
                                   "/usr/share/fonts/dejavu",
                                   "/usr/share/fonts/dejavu-sans-fonts",
                                   "/usr/share/fonts/TTF",
                                   "/usr/local/share/fonts",
                                   "/usr/local/share/fonts/dejavu"};
  if (const char* home = std::getenv("HOME")) list.push_back(std::string(home) + "/.local/share/fonts");
  return list;
}

std::string find(const std::string& name) {
  for (const std::string& folder : folders()) {
    std::error_code error;
    const std::string path = folder + "/" + name;
    if (std::filesystem::is_regular_file(path, error)) return path;
  }
  return {};
}

struct Placed {  // a glyph and where it stands on the base line, px from the text's start
  FT_Face face;
  FT_UInt glyph;
  double x;
};

}  // namespace

struct Fonts::Library {
  FT_Library freetype = nullptr;
  std::vector<FT_Face> regular, bold;  // in the order in which they are asked for a glyph

  ~Library() {
    for (const auto* faces : {&regular, &bold})
      for (const FT_Face face : *faces) FT_Done_Face(face);
    if (freetype != nullptr) FT_Done_FreeType(freetype);
  }

  void open(const std::string& name, std::vector<FT_Face>& into) {
    const std::string path = find(name);
    FT_Face face = nullptr;
    if (!path.empty() && FT_New_Face(freetype, path.c_str(), 0, &face) == 0) into.push_back(face);
  }

  // The first face that has the character; the first of all, with its missing-glyph box, if none has.
  std::pair<FT_Face, FT_UInt> choose(char32_t point, bool heavy) const {
    const auto& faces = heavy && !bold.empty() ? bold : regular;
    for (const auto* list : {&faces, &regular})
      for (const FT_Face face : *list)
        if (const FT_UInt glyph = FT_Get_Char_Index(face, point)) return {face, glyph};
    return {faces.front(), 0};
  }

  std::vector<Placed> lay_out(const core::Text& text, double& width) const {
    std::vector<Placed> line;
    const auto size = static_cast<FT_F26Dot6>(std::lround(text.size * 64));
    FT_Face last_face = nullptr;
    FT_UInt last = 0;
    width = 0;
    for (std::size_t i = 0; i < text.text.size();) {
      const auto [face, glyph] = choose(core::next_code_point(text.text, i), text.bold);
      check(FT_Set_Char_Size(face, 0, size, 72, 72), "set the size of a font");
      FT_Vector kerning{0, 0};
      if (face == last_face) FT_Get_Kerning(face, last, glyph, FT_KERNING_UNFITTED, &kerning);
      width += static_cast<double>(kerning.x) / 64;
      line.push_back({face, glyph, width});
      check(FT_Load_Glyph(face, glyph, load_flags), "load a glyph");
      width += static_cast<double>(face->glyph->linearHoriAdvance) / 65536;
      last_face = face;
      last = glyph;
    }
    return line;
  }

  // One glyph, turned, at a fraction of a pixel; with halo > 0 its widened outline instead.
  void stamp(Canvas& canvas, const Placed& placed, const core::Text& text, core::Place start, double halo) const {
    const double angle = -text.turn * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
    const double x = start.x + placed.x * c, y = start.y - placed.x * s;
    check(FT_Load_Glyph(placed.face, placed.glyph, load_flags), "load a glyph");
    FT_Glyph glyph = nullptr;
    check(FT_Get_Glyph(placed.face->glyph, &glyph), "copy a glyph");
    const std::unique_ptr<FT_Glyph, void (*)(FT_Glyph*)> owner(&glyph, [](FT_Glyph* g) { FT_Done_Glyph(*g); });
    if (halo > 0) widen(glyph, halo);
    const auto sixteenth = [](double v) { return static_cast<FT_Fixed>(std::lround(v * 65536)); };
    FT_Matrix turn{sixteenth(c), sixteenth(-s), sixteenth(s), sixteenth(c)};
    FT_Vector shift{std::lround((x - std::floor(x)) * 64), std::lround((std::ceil(y) - y) * 64)};
    FT_Glyph_Transform(glyph, &turn, &shift);
    check(FT_Glyph_To_Bitmap(&glyph, FT_RENDER_MODE_NORMAL, nullptr, 1), "draw a glyph");
    const auto* bitmap = reinterpret_cast<FT_BitmapGlyph>(glyph);
    const FT_Bitmap& pixels = bitmap->bitmap;
    if (pixels.width == 0 || pixels.rows == 0 || pixels.pitch < 0) return;
    const cv::Mat coverage(static_cast<int>(pixels.rows), static_cast<int>(pixels.width), CV_8UC1, pixels.buffer,
                           static_cast<std::size_t>(pixels.pitch));
    canvas.stamp(coverage, static_cast<int>(std::floor(x)) + bitmap->left, static_cast<int>(std::ceil(y)) - bitmap->top,
                 halo > 0 ? core::rgb(0xffffff) : text.colour);
  }

  void widen(FT_Glyph& glyph, double halo) const {
    FT_Stroker stroker = nullptr;
    check(FT_Stroker_New(freetype, &stroker), "make a stroker");
    FT_Stroker_Set(stroker, std::lround(halo * 64), FT_STROKER_LINECAP_ROUND, FT_STROKER_LINEJOIN_ROUND, 0);
    const FT_Error error = FT_Glyph_StrokeBorder(&glyph, stroker, 0, 1);
    FT_Stroker_Done(stroker);
    if (error != 0 && error != FT_Err_Invalid_Argument) check(error, "widen a glyph");
  }
};

Fonts::Fonts() : library_(std::make_unique<Library>()) {
  check(FT_Init_FreeType(&library_->freetype), "start");
  library_->open("DejaVuSans.ttf", library_->regular);
  library_->open("DejaVuSansMono.ttf", library_->regular);
  library_->open("DejaVuSans-Bold.ttf", library_->bold);
  if (!library_->regular.empty()) return;
  std::string searched;
  for (const std::string& folder : folders()) searched += (searched.empty() ? "" : ", ") + folder;
  throw Error(Exit::data, "cannot draw text: expected the font DejaVuSans.ttf, found none in " + searched +
                              "; install the package fonts-dejavu-core or set WEND_FONTS to the font's folder");
}

Fonts::~Fonts() = default;

double Fonts::width(const core::Text& text) {
  double width = 0;
  library_->lay_out(text, width);
  return width;
}

bool Fonts::has(char32_t point) {
  return library_->choose(point, false).second != 0;
}

void Fonts::draw(Canvas& canvas, const core::Text& text) {
  double width = 0;
  const std::vector<Placed> line = library_->lay_out(text, width);
  const double back = text.anchor == core::Anchor::start ? 0 : text.anchor == core::Anchor::middle ? width / 2 : width;
  const double angle = text.turn * 3.14159265358979323846 / 180;
  const core::Place start{text.at.x - back * std::cos(angle), text.at.y - back * std::sin(angle)};
  if (text.halo > 0)
    for (const Placed& placed : line) library_->stamp(canvas, placed, text, start, text.halo);
  for (const Placed& placed : line) library_->stamp(canvas, placed, text, start, 0);
}

}  // namespace wend::render
