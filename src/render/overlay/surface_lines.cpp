#include "render/overlay/surface_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "base/parallel.h"
#include "render/overlay/text_size.h"

namespace aeolic {
namespace {

constexpr int kBand = 16;  ///< Rows that are drawn together.

/// A line lies on the surface, but neither exactly nor at a pixel's centre. It counts as hidden where it is farther
/// away than the surface by more than that changes over so many pixels, and by more than this part of the depth.
constexpr float kSlackPx = 1.5f, kSlackPart = 2e-3f;

/// A point of the image, and 1 / depth there.
struct Seen {
    glm::vec2 px{0};
    float invDepth = 0;
};

/// Something drawn: the way from one point to another, or a mark, whose two points are the same.
struct Piece {
    Seen a, b;
    std::optional<MarkShape> mark;
};

/// A point in the eye's axes: to the right, down and ahead.
glm::vec3 fromEye(const View& view, const glm::vec3& point)
{
    const glm::vec3 way = point / float(view.unitWorld) - view.eyeLocal;
    return {glm::dot(way, view.right), -glm::dot(way, view.up), glm::dot(way, view.forward)};
}

Seen seenAt(const View& view, const glm::vec3& way)
{
    const float inverse = 1 / way.z;
    return {{view.centerX + view.focalPx * way.x * inverse, view.centerY + view.focalPx * way.y * inverse}, inverse};
}

/// The part of a segment before the eye, as the image shows it.
std::optional<Piece> pieceOf(const View& view, glm::vec3 a, glm::vec3 b)
{
    const auto near = float(view.nearDepth);
    if (a.z < near && b.z < near) return {};
    if (a.z < near) a += (near - a.z) / (b.z - a.z) * (b - a);
    if (b.z < near) b += (near - b.z) / (a.z - b.z) * (a - b);
    return Piece{seenAt(view, a), seenAt(view, b), {}};
}

std::vector<Piece> piecesOf(const View& view, const SurfaceLines::Style& style)
{
    std::vector<Piece> pieces;
    for (const std::vector<glm::vec3>& line : style.lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (const auto piece = pieceOf(view, fromEye(view, line[i]), fromEye(view, line[i + 1])))
                pieces.push_back(*piece);
    for (const SurfaceLines::Mark& mark : style.marks)
        if (const glm::vec3 way = fromEye(view, mark.at); way.z >= float(view.nearDepth))
            pieces.push_back({seenAt(view, way), seenAt(view, way), mark.shape});
    return pieces;
}

/// How far a place is from what a mark covers, in pixels; less than 0 inside.
float distanceTo(MarkShape shape, const glm::vec2& from, float radius, float width)
{
    const float far = glm::length(from), ring = std::abs(far - (radius - 0.5f * width)) - 0.5f * width;
    switch (shape) {
        case MarkShape::disc:
            return far - radius;
        case MarkShape::ring:
            return ring;
        case MarkShape::ringWithDot:
            return std::min(ring, far - 0.35f * radius);
        case MarkShape::cross:
            break;
    }
    // The two diagonals.
    const float along = std::abs(from.x + from.y) * 0.70710678f, across = std::abs(from.x - from.y) * 0.70710678f;
    const auto bar = [&](float u, float v) {
        return glm::length(glm::vec2(std::max(u - (radius - 0.5f * width), 0.0f), v)) - 0.5f * width;
    };
    return std::min(bar(along, across), bar(across, along));
}

struct Nearest {
    float distance;  ///< To the style's line or mark, less than 0 inside.
    glm::vec2 off;   ///< From the pixel's centre to the place that is drawn.
    float invDepth;
};

Nearest nearest(const Piece& piece, const glm::vec2& pixel, const SurfaceLines::Look& look)
{
    const glm::vec2 way = piece.b.px - piece.a.px;
    const float squared = glm::dot(way, way);
    const float part = squared > 0 ? std::clamp(glm::dot(pixel - piece.a.px, way) / squared, 0.0f, 1.0f) : 0;
    const glm::vec2 off = piece.a.px + part * way - pixel;
    const float invDepth = piece.a.invDepth + part * (piece.b.invDepth - piece.a.invDepth);
    const float distance = piece.mark ? distanceTo(*piece.mark, -off, 0.5f * look.markPx, look.widthPx)
                                      : glm::length(off) - 0.5f * look.widthPx;
    return {distance, off, invDepth};
}

bool isHidden(const SeenSurface& seen, int x, int y, const Nearest& at)
{
    const float surface = seen.invDepth.at(x, y);
    if (!(surface > 0)) return false;
    const float gradX = seen.gradX.at(x, y), gradY = seen.gradY.at(x, y);
    const float there = surface + gradX * at.off.x + gradY * at.off.y;
    const float slackPx = kSlackPx + 0.5f * glm::length(at.off);
    return at.invDepth < there - slackPx * (std::abs(gradX) + std::abs(gradY)) - kSlackPart * surface;
}

/// How much of each pixel of a band a style covers: its line, and with its casing.
struct Coverage {
    std::vector<float> line, cased;
    Coverage(int width, int rows) : line(std::size_t(width) * std::size_t(rows)), cased(line.size()) {}
};

void cover(const Piece& piece, const SurfaceLines::Look& look, const SeenSurface& seen, const Extent& band,
           Coverage& all)
{
    const float beside = 0.5f * (piece.mark ? look.markPx : look.widthPx) + look.casingPx + 1;
    const glm::vec2 lo = glm::min(piece.a.px, piece.b.px) - beside, hi = glm::max(piece.a.px, piece.b.px) + beside;
    const auto clampTo = [](float value, int least, int most) {
        return int(std::clamp(std::floor(value), float(least), float(most)));
    };
    const int x0 = clampTo(lo.x, band.x0, band.x1), x1 = clampTo(hi.x + 1, band.x0, band.x1);
    const int y0 = clampTo(lo.y, band.y0, band.y1), y1 = clampTo(hi.y + 1, band.y0, band.y1);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const Nearest at = nearest(piece, {float(x) + 0.5f, float(y) + 0.5f}, look);
            const float line = std::clamp(0.5f - at.distance, 0.0f, 1.0f),
                        cased = std::clamp(0.5f - at.distance + look.casingPx, 0.0f, 1.0f);
            if (cased == 0 || isHidden(seen, x, y, at)) continue;
            const std::size_t i = std::size_t(y - band.y0) * std::size_t(band.width()) + std::size_t(x - band.x0);
            all.line[i] = std::max(all.line[i], line);
            all.cased[i] = std::max(all.cased[i], cased);
        }
}

/// Lays a colour over a pixel, RGBA and not premultiplied.
void lay(const std::array<std::uint8_t, 3>& color, float part, std::array<std::uint8_t, 4>& pixel)
{
    const float under = float(pixel[3]) / 255 * (1 - part), alpha = part + under;
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = std::uint8_t(std::lround((part * float(color[c]) + under * float(pixel[c])) / alpha));
    pixel[3] = std::uint8_t(std::lround(255 * alpha));
}

void paint(const SurfaceLines::Look& look, const Extent& band, const Coverage& coverage, Tile& out)
{
    std::size_t i = 0;
    for (int y = band.y0; y < band.y1; ++y)
        for (int x = band.x0; x < band.x1; ++x, ++i) {
            if (coverage.cased[i] == 0) continue;
            std::array<std::uint8_t, 4> pixel{};
            std::copy_n(out.row(y) + 4 * std::ptrdiff_t(x - out.extent.x0), 4, pixel.begin());
            lay(look.casing, coverage.cased[i], pixel);
            if (coverage.line[i] > 0) lay(look.color, coverage.line[i], pixel);
            out.put(x, y, pixel);
        }
}

bool meets(const Piece& piece, const Extent& band, float beside)
{
    const auto [top, bottom] = std::minmax(piece.a.px.y, piece.b.px.y);
    return bottom + beside >= float(band.y0) && top - beside <= float(band.y1);
}

/// The look at the picture's own size.
SurfaceLines::Look lookIn(const Camera& camera, SurfaceLines::Look look)
{
    constexpr int usual = 800;
    const auto scale = float(textSize(camera.width, camera.height) / textSize(usual, usual));
    for (float* px : {&look.widthPx, &look.casingPx, &look.markPx}) *px *= scale;
    return look;
}

}  // namespace

void SurfaceLines::draw(const View& view, const SeenSurface& seen, Tile& out) const
{
    const Extent& rows = seen.rows();
    if (rows.empty()) return;
    std::vector<std::vector<Piece>> pieces;
    std::vector<Look> looks;
    for (const Style& style : styles_) {
        pieces.push_back(piecesOf(view, style));
        looks.push_back(lookIn(view.camera, style.look));
    }
    const auto bands = std::size_t((rows.height() + kBand - 1) / kBand);
    parallelFor(bands, [&](std::size_t i) {
        Extent band = rows;
        band.y0 = rows.y0 + int(i) * kBand;
        band.y1 = std::min(band.y0 + kBand, rows.y1);
        for (std::size_t s = 0; s < styles_.size(); ++s) {
            const Look& look = looks[s];
            const float beside = 0.5f * std::max(look.widthPx, look.markPx) + look.casingPx + 1;
            Coverage coverage(band.width(), band.height());
            bool any = false;
            for (const Piece& piece : pieces[s]) {
                if (!meets(piece, band, beside)) continue;
                cover(piece, look, seen, band, coverage);
                any = true;
            }
            if (any) paint(look, band, coverage, out);
        }
    });
}

}  // namespace aeolic
