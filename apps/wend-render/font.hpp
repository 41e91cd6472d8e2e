// Glyphs from the DejaVu fonts, through FreeType.
#pragma once
#include <memory>
#include <string>

#include "canvas.hpp"

namespace wend::render {

class Fonts {
 public:
  // Throws Error(Exit::data) where DejaVuSans.ttf is in none of the usual folders.
  Fonts();
  ~Fonts();

  // `at` and `size` in pixels of the picture.
  void draw(Canvas& canvas, const core::Text& text);

  // In pixels, kerned.
  double width(const core::Text& text);

  // Whether a font has a glyph for this code point.
  bool has(char32_t point);

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace wend::render
