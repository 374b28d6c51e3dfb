#include "render/overlay/strokes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "render/overlay/text_size.h"

namespace aeolic {
namespace {

constexpr int kBand = 16;  ///< Rows that are drawn together.

/// A line lies on the surface, but neither exactly nor at a pixel's centre. It counts as hidden where it is farther
/// away than the surface by more than that changes over so many pixels, and by more than this part of the depth.
constexpr float kSlackPx = 1.5f, kSlackPart = 2e-3f;

/// A stroke with a normal is hidden where the cosine between that and the normal seen is less: the first where the
/// normal faces the viewer, the second where it faces away, and what is seen is the other side of the same sheet, or
/// another one before it.
constexpr float kOtherSheet = -0.25f, kOtherSide = 0.8f;

/// A head is so wide, as a part of its length.
constexpr float kHeadWidth = 0.75f;

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
        case MarkShape::head:
            break;
    }
    // The two diagonals.
    const float along = std::abs(from.x + from.y) * 0.70710678f, across = std::abs(from.x - from.y) * 0.70710678f;
    const auto bar = [&](float u, float v) {
        return glm::length(glm::vec2(std::max(u - (radius - 0.5f * width), 0.0f), v)) - 0.5f * width;
    };
    return std::min(bar(along, across), bar(across, along));
}

/// How far a place is from a triangle whose middle is the origin, and whose tip lies in the direction `ahead`, in
/// pixels; less than 0 inside. Half of it is looked at, with the tip as the origin: its side is a line from there to
/// the corner.
float distanceToHead(const glm::vec2& from, const glm::vec2& ahead, float length)
{
    const glm::vec2 corner(0.5f * kHeadWidth * length, length),
        place(std::abs(ahead.x * from.y - ahead.y * from.x), 0.5f * length - glm::dot(from, ahead));
    if (!(length > 0)) return glm::length(from);
    const float along = std::clamp(glm::dot(place, corner) / glm::dot(corner, corner), 0.0f, 1.0f),
                across = std::clamp(place.x / corner.x, 0.0f, 1.0f);
    const float toSide = glm::length(place - along * corner),
                toBase = glm::length(place - glm::vec2(across * corner.x, corner.y));
    const bool isInside = place.y <= corner.y && place.x * corner.y <= place.y * corner.x;
    return (isInside ? -1.0f : 1.0f) * std::min(toSide, toBase);
}

/// From a place in the picture to the eye, world axes.
glm::vec3 toViewer(const View& view, const StrokeEnd& end)
{
    const glm::vec2 way = (end.px - glm::vec2(view.centerX, view.centerY)) / view.focalPx;
    return -(way.x * view.right - way.y * view.up + view.forward);
}

struct Nearest {
    float distance;  ///< To the stroke, less than 0 inside.
    glm::vec2 off;   ///< From the pixel's centre to the place that is drawn.
    float invDepth;
    float part;
};

Nearest nearest(const Stroke& stroke, const glm::vec2& pixel, const StrokeLook& look)
{
    const glm::vec2 way = stroke.b.px - stroke.a.px;
    const float squared = glm::dot(way, way);
    if (stroke.mark == MarkShape::head) {
        const glm::vec2 off = stroke.a.px - pixel;
        const float size = stroke.a.part * look.markPx;
        return {distanceToHead(-off, squared > 0 ? way / std::sqrt(squared) : glm::vec2(1, 0), size), off,
                stroke.a.invDepth, stroke.a.part};
    }
    const float along = squared > 0 ? std::clamp(glm::dot(pixel - stroke.a.px, way) / squared, 0.0f, 1.0f) : 0;
    const glm::vec2 off = stroke.a.px + along * way - pixel;
    const float invDepth = stroke.a.invDepth + along * (stroke.b.invDepth - stroke.a.invDepth),
                part = stroke.a.part + along * (stroke.b.part - stroke.a.part);
    const float distance = stroke.mark ? distanceTo(*stroke.mark, -off, 0.5f * look.markPx, look.widthPx)
                                       : glm::length(off) - 0.5f * part * look.widthPx;
    return {distance, off, invDepth, part};
}

/// Whether the surface hides a stroke, pixel by pixel.
class Hiding {
public:
    Hiding(const View& view, const SeenSurface& seen, const Stroke& stroke)
        : view_(view), seen_(seen), normal_(stroke.normal), hasNormal_(stroke.normal != glm::vec3(0))
    {
        if (!hasNormal_ || glm::dot(normal_, toViewer(view, stroke.a)) >= 0) return;
        normal_ = -normal_;
        leastCosine_ = kOtherSide;
    }

    bool hides(int x, int y, const Nearest& at) const
    {
        const float surface = seen_.invDepth.at(x, y);
        if (!(surface > 0)) return hasNormal_;
        const float gradX = seen_.gradX.at(x, y), gradY = seen_.gradY.at(x, y);
        const float there = surface + gradX * at.off.x + gradY * at.off.y;
        const float slackPx = kSlackPx + 0.5f * glm::length(at.off);
        if (at.invDepth < there - slackPx * (std::abs(gradX) + std::abs(gradY)) - kSlackPart * surface) return true;
        return hasNormal_ && glm::dot(normal_, seen_.normal(view_, x, y)) < leastCosine_;
    }

private:
    const View& view_;
    const SeenSurface& seen_;
    glm::vec3 normal_;
    bool hasNormal_;
    float leastCosine_ = kOtherSheet;
};

/// How much of each pixel of a band a layer covers: its strokes, and with their casing.
struct Coverage {
    std::vector<float> line, cased;
    Coverage(int width, int rows) : line(std::size_t(width) * std::size_t(rows)), cased(line.size()) {}
};

/// How far beside a stroke's ends it may cover pixels.
float reachOf(const StrokeLook& look, const Stroke& stroke)
{
    const float size = stroke.mark == MarkShape::head ? 1.25f * look.markPx  // Its base's corners.
                       : stroke.mark                  ? look.markPx
                                                      : look.widthPx;
    return 0.5f * size + look.casingPx + 1;
}

/// From which column to which a stroke may cover pixels of a row.
std::pair<float, float> columnsNear(const Stroke& stroke, float row, float beside)
{
    glm::vec2 a = stroke.a.px, b = stroke.b.px;
    if (a.y > b.y) std::swap(a, b);
    const glm::vec2 way = b - a;
    if (way.y > beside) {
        const float from = std::clamp((row - beside - a.y) / way.y, 0.0f, 1.0f),
                    to = std::clamp((row + beside - a.y) / way.y, 0.0f, 1.0f);
        b = a + to * way;
        a += from * way;
    }
    return {std::min(a.x, b.x) - beside, std::max(a.x, b.x) + beside};
}

void cover(const View& view, const Stroke& stroke, const StrokeLook& look, const SeenSurface& seen, const Extent& band,
           Coverage& all)
{
    const Hiding hiding(view, seen, stroke);
    const float beside = reachOf(look, stroke);
    const auto clampTo = [](float value, int least, int most) {
        return int(std::clamp(std::floor(value), float(least), float(most)));
    };
    const auto [top, bottom] = std::minmax(stroke.a.px.y, stroke.b.px.y);
    const int y0 = clampTo(top - beside, band.y0, band.y1), y1 = clampTo(bottom + beside + 1, band.y0, band.y1);
    for (int y = y0; y < y1; ++y) {
        const auto [left, right] = columnsNear(stroke, float(y) + 0.5f, beside);
        const int x0 = clampTo(left, band.x0, band.x1), x1 = clampTo(right + 1, band.x0, band.x1);
        for (int x = x0; x < x1; ++x) {
            const Nearest at = nearest(stroke, {float(x) + 0.5f, float(y) + 0.5f}, look);
            const float line = at.part * std::clamp(0.5f - at.distance, 0.0f, 1.0f),
                        cased = at.part * std::clamp(0.5f - at.distance + at.part * look.casingPx, 0.0f, 1.0f);
            const std::size_t i = std::size_t(y - band.y0) * std::size_t(band.width()) + std::size_t(x - band.x0);
            const bool isMore =
                line > all.line[i] || cased > all.cased[i];  // Neighbours on a line cover the same pixels.
            if (!isMore || hiding.hides(x, y, at)) continue;
            all.line[i] = std::max(all.line[i], line);
            all.cased[i] = std::max(all.cased[i], cased);
        }
    }
}

/// Lays a colour over a pixel, RGBA and not premultiplied.
void lay(const std::array<std::uint8_t, 3>& color, float part, std::array<std::uint8_t, 4>& pixel)
{
    const float under = float(pixel[3]) / 255 * (1 - part), alpha = part + under;
    if (!(alpha > 0)) return;
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = std::uint8_t(std::lround((part * float(color[c]) + under * float(pixel[c])) / alpha));
    pixel[3] = std::uint8_t(std::lround(255 * alpha));
}

void paint(const StrokeLook& look, const Extent& band, const Coverage& coverage, Tile& out)
{
    std::size_t i = 0;
    for (int y = band.y0; y < band.y1; ++y)
        for (int x = band.x0; x < band.x1; ++x, ++i) {
            if (coverage.cased[i] == 0) continue;
            std::array<std::uint8_t, 4> pixel{};
            std::copy_n(out.row(y) + 4 * std::ptrdiff_t(x - out.extent.x0), 4, pixel.begin());
            lay(look.casing, look.casingPart * coverage.cased[i], pixel);
            if (coverage.line[i] > 0) lay(look.color, coverage.line[i], pixel);
            out.put(x, y, pixel);
        }
}

glm::dvec2 inPicture(const View& view, const glm::vec3& fromEye)
{
    return glm::dvec2(view.centerX, view.centerY) +
           double(view.focalPx) / double(fromEye.z) * glm::dvec2(fromEye.x, fromEye.y);
}

/// Which strokes of a layer meet each band of rows.
class Bands {
public:
    Bands(const StrokeLayer& layer, const Extent& rows) : first_(std::size_t(bandsIn(rows)) + 1)
    {
        const auto visit = [&](const auto& take) {
            for (std::uint32_t i = 0; i < layer.strokes.size(); ++i) {
                const Stroke& stroke = layer.strokes[i];
                const auto [top, bottom] = std::minmax(stroke.a.px.y, stroke.b.px.y);
                const float beside = reachOf(layer.look, stroke), lo = top - beside - float(rows.y0),
                            hi = bottom + beside - float(rows.y0);
                if (!(hi >= 0 && lo <= float(rows.height()))) continue;
                const int last = std::min(int(std::min(hi, float(rows.height()))) / kBand, bandsIn(rows) - 1);
                for (int b = int(std::max(lo, 0.0f)) / kBand; b <= last; ++b) take(std::size_t(b), i);
            }
        };
        visit([&](std::size_t band, std::uint32_t) { ++first_[band + 1]; });
        for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
        strokes_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        visit([&](std::size_t band, std::uint32_t i) { strokes_[next[band]++] = i; });
    }

    static int bandsIn(const Extent& rows) { return (rows.height() + kBand - 1) / kBand; }

    template <class Visit>
    bool forEach(std::size_t band, const Visit& visit) const
    {
        for (std::size_t k = first_[band]; k < first_[band + 1]; ++k) visit(strokes_[k]);
        return first_[band] < first_[band + 1];
    }

private:
    std::vector<std::size_t> first_;  // [bands + 1]
    std::vector<std::uint32_t> strokes_;
};

}  // namespace

float strokeScale(const Camera& camera)
{
    constexpr int usual = 800;
    return float(textSize(camera.width, camera.height) / textSize(usual, usual));
}

StrokeLook StrokeLook::in(const Camera& camera) const
{
    StrokeLook look = *this;
    for (float* px : {&look.widthPx, &look.casingPx, &look.markPx}) *px *= strokeScale(camera);
    return look;
}

StrokeEnd strokeEnd(const View& view, const glm::vec3& fromEye, float part)
{
    return {glm::vec2(inPicture(view, fromEye)), 1 / fromEye.z, part};
}

std::optional<Stroke> strokeOf(const View& view, glm::vec3 a, glm::vec3 b, float partA, float partB)
{
    const auto near = float(view.nearDepth);
    if (!(a.z >= near || b.z >= near)) return {};
    if (a.z < near) a += (near - a.z) / (b.z - a.z) * (b - a);
    if (b.z < near) b += (near - b.z) / (a.z - b.z) * (a - b);
    const glm::dvec2 from = inPicture(view, a), way = inPicture(view, b) - from,
                     size(view.camera.width, view.camera.height);
    double first = 0, last = 1;  // Parts of the way between which it is in the picture or beside it.
    for (int axis = 0; axis < 2; ++axis) {
        const double lo = -size[axis] - from[axis], hi = 2 * size[axis] - from[axis];
        if (way[axis] == 0 && (lo > 0 || hi < 0)) return {};
        if (way[axis] == 0) continue;
        first = std::max(first, std::min(lo / way[axis], hi / way[axis]));
        last = std::min(last, std::max(lo / way[axis], hi / way[axis]));
    }
    if (!(first <= last)) return {};
    const auto at = [&](double part) {  // 1 / depth is linear in the image.
        const auto p = float(part);
        return StrokeEnd{glm::vec2(from + part * way), (1 - p) / a.z + p / b.z, (1 - p) * partA + p * partB};
    };
    return Stroke{at(first), at(last), {}};
}

void drawStrokes(const View& view, const std::vector<StrokeLayer>& layers, const SeenSurface& seen, Tile& out)
{
    const Extent& rows = seen.rows();
    if (rows.empty()) return;
    std::vector<Bands> bands;
    bands.reserve(layers.size());
    for (const StrokeLayer& layer : layers) bands.emplace_back(layer, rows);
    parallelFor(std::size_t(Bands::bandsIn(rows)), [&](std::size_t i) {
        Extent band = rows;
        band.y0 = rows.y0 + int(i) * kBand;
        band.y1 = std::min(band.y0 + kBand, rows.y1);
        for (std::size_t l = 0; l < layers.size(); ++l) {
            Coverage coverage(band.width(), band.height());
            const StrokeLook& look = layers[l].look;
            const bool any = bands[l].forEach(
                i, [&](std::uint32_t s) { cover(view, layers[l].strokes[s], look, seen, band, coverage); });
            if (any) paint(look, band, coverage, out);
        }
    });
}

}  // namespace aeolic
