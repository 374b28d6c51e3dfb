#include "render/overlay/drawn_text.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "base/text.h"

extern "C" const unsigned char aeolicFontBegin[];
extern "C" const unsigned char aeolicFontEnd[];

namespace aeolic {

namespace {

constexpr std::size_t longestText = 400;  // Characters; more never fits a picture's title.
constexpr char32_t replacement = 0xfffd, ellipsis = 0x2026;

/// What is not UTF-8, and control characters, are the replacement character.
char32_t shownCharacter(std::string_view text, std::size_t& at)
{
    const char32_t code = nextCharacter(text, at).value_or(replacement);
    return code < 0x20 || code == 0x7f ? replacement : code;
}

std::vector<char32_t> characters(std::string_view text)
{
    std::vector<char32_t> all;
    for (std::size_t at = 0; at < text.size() && all.size() < longestText;) all.push_back(shownCharacter(text, at));
    return all;
}

void check(FT_Error error)
{
    if (error != 0)
        throw std::runtime_error("the embedded label font cannot be used (FreeType error " + std::to_string(error) +
                                 ")");
}

}  // namespace

void blendPixel(const PictureRows& picture, int x, int y, const Rgb& color, unsigned alpha)
{
    const int row = y - picture.firstRow;
    if (x < 0 || row < 0 || x >= picture.width || row >= picture.rows || alpha == 0) return;
    std::uint8_t* pixel = picture.pixels + (std::size_t(row) * std::size_t(picture.width) + std::size_t(x)) *
                                               std::size_t(picture.channels);
    // "Over" for colours that are not premultiplied, in integers; opaque pixels are the case below = 255.
    const unsigned below = picture.channels == 4 ? pixel[3] : 255;
    const unsigned weightBelow = below * (255 - alpha);
    const unsigned weight = alpha * 255 + weightBelow;  // 255 * the opacity of the result
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = std::uint8_t((color[c] * alpha * 255 + pixel[c] * weightBelow + weight / 2) / weight);
    if (picture.channels == 4) pixel[3] = std::uint8_t((weight + 127) / 255);
}

struct TextPainter::Font {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    explicit Font(double sizePx)
    {
        check(FT_Init_FreeType(&library));
        try {
            check(FT_New_Memory_Face(library, aeolicFontBegin, FT_Long(aeolicFontEnd - aeolicFontBegin), 0, &face));
            check(FT_Set_Char_Size(face, 0, FT_F26Dot6(std::lround(sizePx * 64)), 72, 72));
        } catch (...) {
            FT_Done_FreeType(library);  // The face goes with it.
            throw;
        }
    }
    ~Font() { FT_Done_FreeType(library); }
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// Walks the text; place(penX, glyph loaded in face->glyph) with the pen in 1/64 pixels. Returns where the pen
    /// ends.
    template <class Place>
    FT_Pos walk(const std::vector<char32_t>& text, const Place& place) const
    {
        FT_Pos pen = 0;
        FT_UInt previous = 0;
        for (char32_t code : text) {
            const FT_UInt glyph = FT_Get_Char_Index(face, code);
            FT_Vector kerning{0, 0};
            if (previous && glyph) FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNFITTED, &kerning);
            pen += kerning.x;
            check(FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP));
            const FT_Pos advance =
                (face->glyph->linearHoriAdvance + 512) >> 10;  // 16.16 to 26.6, not rounded to pixels
            place(pen);
            pen += advance;
            previous = glyph;
        }
        return pen;
    }

    double width(const std::vector<char32_t>& text) const
    {
        return double(walk(text, [](FT_Pos) {})) / 64;
    }
};

TextPainter::TextPainter(double sizePx) : font_(std::make_unique<Font>(std::max(1.0, sizePx))) {}

TextPainter::~TextPainter() = default;

double TextPainter::widthPx(std::string_view text) const
{
    return font_->width(characters(text));
}

double TextPainter::digitHeightPx() const
{
    check(FT_Load_Char(font_->face, '0', FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP));
    return double(font_->face->glyph->metrics.horiBearingY) / 64;
}

std::string TextPainter::unknownIn(std::string_view text) const
{
    std::string unknown;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        const char32_t code = shownCharacter(text, at);
        const std::string_view character = text.substr(begin, at - begin);
        if (code == replacement || FT_Get_Char_Index(font_->face, code) != 0) continue;
        if (unknown.find(character) == unknown.npos) unknown += character;
    }
    return unknown;
}

std::string TextPainter::fitted(std::string_view text, double widestPx) const
{
    std::vector<std::size_t> ends{0};  // Bytes of the first n characters.
    std::vector<char32_t> kept;
    for (std::size_t at = 0; at < text.size() && kept.size() < longestText; ends.push_back(at))
        kept.push_back(shownCharacter(text, at));
    if (ends.back() == text.size() && font_->width(kept) <= widestPx) return std::string(text);
    for (;;) {
        kept.push_back(ellipsis);
        const bool fits = font_->width(kept) <= widestPx;
        kept.pop_back();
        if (fits) return std::string(text.substr(0, ends[kept.size()])) + "…";
        if (kept.empty()) return "";
        kept.pop_back();
    }
}

void TextPainter::draw(const PictureRows& picture, double x, int baseline, std::string_view text,
                       const Rgb& color) const
{
    const FT_Pos start = FT_Pos(std::floor(x * 64 + 0.5));
    const FT_GlyphSlot glyph = font_->face->glyph;
    font_->walk(characters(text), [&](FT_Pos pen) {
        const FT_Pos at = start + pen;
        FT_Outline_Translate(&glyph->outline, at & 63, 0);
        check(FT_Render_Glyph(glyph, FT_RENDER_MODE_NORMAL));
        const FT_Bitmap& bitmap = glyph->bitmap;
        const int left = int(at >> 6) + glyph->bitmap_left, top = baseline - glyph->bitmap_top;
        for (unsigned row = 0; row < bitmap.rows; ++row)
            for (unsigned column = 0; column < bitmap.width; ++column)
                blendPixel(picture, left + int(column), top + int(row), color,
                           bitmap.buffer[std::ptrdiff_t(row) * bitmap.pitch + std::ptrdiff_t(column)]);
    });
}

}  // namespace aeolic
