#include "render/overlay/streamline_strokes.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace aeolic {
namespace {

/// A level shows where its lines are this far apart in the picture, in parts of the spacing asked for: nothing of it
/// below the first, all of it from the second on. Twice the first is more than the second, so that each level is there
/// before the next one comes.
constexpr float kNone = 0.55f, kAll = 0.8f;

/// Heads on a line are so many spacings of its level apart, and in the picture at least so many lengths of a head.
constexpr float kHeadSpacings = 6, kHeadLengths = 3;

/// Levels are made for what is this many times half a picture beside its middle, or nearer.
constexpr float kNear = 3;

constexpr StrokeLook kLine{{25, 25, 25}, {255, 255, 255}, 1.9f, 1.2f, 11, 0.8f};

/// From 0 to 1 without a kink.
float smooth(float value, float lo, float hi)
{
    const float part = std::clamp((value - lo) / (hi - lo), 0.0f, 1.0f);
    return part * part * (3 - 2 * part);
}

/// A point of a line as the picture shows it.
struct Shown {
    glm::vec3 way{0};    ///< From the eye.
    glm::vec2 along{0};  ///< What a unit of length along the line is in the picture, in pixels.
    float acrossPx = 0;  ///< How far apart lines are that are one unit apart on the surface.
};

/// How lines show in a view. Lengths count in the lines' unit.
class LineView {
public:
    LineView(const View& view, double unitWorld, float spacingPx)
        : view_(view), unitWorld_(unitWorld), unit_(float(unitWorld / view.unitWorld)), spacingPx_(spacingPx)
    {
    }

    Shown of(const StreamlinePoint& point, const glm::vec3& along) const
    {
        Shown shown{fromEye(point.at)};
        if (!(shown.way.z >= float(view_.nearDepth))) return shown;
        const float inverse = 1 / shown.way.z;
        const auto inPicture = [&](const glm::vec3& direction) {
            const glm::vec3 d(glm::dot(direction, view_.right), -glm::dot(direction, view_.up),
                              glm::dot(direction, view_.forward));
            return view_.focalPx * unit_ * inverse *
                   (glm::vec2(d.x, d.y) - d.z * inverse * glm::vec2(shown.way.x, shown.way.y));
        };
        shown.along = inPicture(along);
        const glm::vec2 across = inPicture(glm::cross(point.normal, along));
        const float length = glm::length(shown.along);
        // The part of the way across that leads away from the line.
        shown.acrossPx =
            length > 0 ? std::abs(shown.along.x * across.y - shown.along.y * across.x) / length : glm::length(across);
        return shown;
    }

    /// How much shows of a level with this spacing, where a unit of length across lines has so many pixels.
    float part(float acrossPx, double spacing) const
    {
        return smooth(acrossPx * float(spacing) / spacingPx_, kNone, kAll);
    }

    /// The most that a unit of length is in the picture at a place, in pixels; 0 far beside the picture.
    float unitPx(const glm::vec3& place) const
    {
        const glm::vec3 way = fromEye(place);
        if (!(way.z >= float(view_.nearDepth))) return 0;
        const glm::vec2 off = glm::abs(view_.focalPx / way.z * glm::vec2(way.x, way.y)),
                        far = kNear * glm::vec2(view_.centerX, view_.centerY);
        return off.x < far.x && off.y < far.y ? view_.focalPx * unit_ * glm::length(way) / (way.z * way.z) : 0;
    }
    /// A level with this spacing shows where a unit of length has so many pixels.
    bool isWanted(float unitPx, double spacing) const { return unitPx * float(spacing) > kNone * spacingPx_; }

    const View& view() const { return view_; }

private:
    glm::vec3 fromEye(const glm::vec3& place) const { return aeolic::fromEye(view_, place, unitWorld_); }

    const View& view_;
    double unitWorld_;
    float unit_, spacingPx_;
};

/// The direction of a line at each of its points, unit length.
glm::vec3 directionAt(const std::vector<StreamlinePoint>& points, std::size_t i)
{
    const glm::vec3 way = points[std::min(i + 1, points.size() - 1)].at - points[i > 0 ? i - 1 : 0].at;
    const float length = glm::length(way);
    return length > 0 ? way / length : glm::vec3(0);
}

bool isNearPicture(const View& view, const glm::vec2& px, float beside)
{
    return px.x > -beside && px.y > -beside && px.x < float(view.camera.width) + beside &&
           px.y < float(view.camera.height) + beside;
}

std::vector<Shown> shownOf(const EvenStreamline& line, const LineView& lineView)
{
    std::vector<Shown> shown;
    for (std::size_t i = 0; i < line.points.size(); ++i)
        shown.push_back(lineView.of(line.points[i], directionAt(line.points, i)));
    return shown;
}

/// The most that a unit of length is in the picture at any of these places.
template <class PlaceOf>
float widestPx(const LineView& lineView, std::size_t count, const PlaceOf& placeOf)
{
    constexpr std::size_t grain = 4096;
    std::vector<float> widest((count + grain - 1) / grain);
    parallelFor(widest.size(), [&](std::size_t part) {
        for (std::size_t i = part * grain; i < std::min(count, (part + 1) * grain); ++i)
            widest[part] = std::max(widest[part], lineView.unitPx(placeOf(i)));
    });
    return widest.empty() ? 0 : *std::max_element(widest.begin(), widest.end());
}

/// How many levels show somewhere in the picture, or near it. It follows from the view alone, never from how many there
/// are already: those are made that are missing. Where no place of the surface that is known is near the picture the
/// view is so close that all levels count.
int levelsFor(const LineView& lineView, EvenStreamlines& all)
{
    const float widest = widestPx(lineView, all.places().size(), [&](std::size_t i) { return all.places()[i]; });
    int level = 0;
    while (widest == 0 || lineView.isWanted(widest, all.spacing(level))) {
        all.refineTo(level);
        if (all.levels() <= level) break;
        ++level;
    }
    return level;
}

/// How much shows of a line that is short in the picture: a crumb tells nothing.
float partOfLength(const std::vector<Shown>& shown, const View& view, float headPx)
{
    float px = 0;
    for (std::size_t i = 0; i + 1 < shown.size(); ++i)
        if (shown[i].way.z >= float(view.nearDepth) && shown[i + 1].way.z >= float(view.nearDepth))
            px += glm::distance(strokeEnd(view, shown[i].way).px, strokeEnd(view, shown[i + 1].way).px);
    return smooth(px, 1.5f * headPx, 3 * headPx);
}

void addLine(const EvenStreamline& line, const std::vector<Shown>& shown, double spacing, const LineView& lineView,
             float linePart, std::vector<Stroke>& out)
{
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const float a = linePart * lineView.part(shown[i].acrossPx, spacing),
                    b = linePart * lineView.part(shown[i + 1].acrossPx, spacing);
        if (!(a > 0 || b > 0)) continue;
        if (auto stroke = strokeOf(lineView.view(), shown[i].way, shown[i + 1].way, a, b)) {
            out.push_back(*stroke);
            out.back().normal = line.points[i].normal;
        }
    }
}

/// The heads on a line: one in it and others every few spacings from there; on finer levels halfway between.
class Heads {
public:
    Heads(const EvenStreamlines& all, const EvenStreamline& line, const std::vector<Shown>& shown,
          const LineView& lineView, float headPx, float linePart, int levels)
        : all_(all),
          line_(line),
          shown_(shown),
          lineView_(lineView),
          headPx_(headPx),
          linePart_(linePart),
          levels_(levels)
    {
    }

    void addTo(std::vector<Stroke>& out) const
    {
        const double begin = line_.points.front().arc, end = line_.points.back().arc;
        const double first = begin + 0.6 * std::min(end - begin, kHeadSpacings * all_.spacing(line_.level));
        float widest = 0;
        for (const Shown& shown : shown_) widest = std::max(widest, shown.acrossPx);
        for (int level = line_.level; level < levels_; ++level) {
            const double spacing = all_.spacing(level), apart = kHeadSpacings * spacing;
            if (!(lineView_.part(widest, spacing) > 0)) return;  // Nor does a finer level show.
            const bool isFirst = level == line_.level;
            const double lo = (begin - first) / apart, hi = (end - first) / apart;
            std::size_t i = 0;
            for (auto k = std::int64_t(std::ceil(lo)); double(k) <= hi; ++k) {
                const auto arc = float(first + double(k) * apart);
                while (i + 2 < line_.points.size() && line_.points[i + 1].arc < arc) ++i;
                if (isFirst || k % 2 != 0) add(i, arc, spacing, float(apart), out);
            }
        }
    }

private:
    void add(std::size_t i, float arc, double spacing, float apart, std::vector<Stroke>& out) const
    {
        const StreamlinePoint &a = line_.points[i], &b = line_.points[i + 1];
        const float part = std::clamp((arc - a.arc) / (b.arc - a.arc), 0.0f, 1.0f);
        const Shown& shown = shown_[part < 0.5f ? i : i + 1];
        const float length = glm::length(shown.along);
        const float behindPx = (arc - line_.points.front().arc) * length;  // A head at the tail reads backwards.
        const float shows =
            linePart_ *
            std::min({lineView_.part(shown.acrossPx, spacing), smooth(behindPx, 0.8f * headPx_, 1.2f * headPx_),
                      smooth(apart * length, 0.5f * kHeadLengths * headPx_, kHeadLengths * headPx_)});
        const glm::vec3 way = shown_[i].way + part * (shown_[i + 1].way - shown_[i].way);
        if (!(shows > 0) || !(way.z >= float(lineView_.view().nearDepth))) return;
        Stroke head{strokeEnd(lineView_.view(), way, shows), strokeEnd(lineView_.view(), way, shows), MarkShape::head};
        if (!isNearPicture(lineView_.view(), head.a.px, headPx_)) return;
        head.b.px += shown.along / length;
        head.normal = a.normal;
        out.push_back(head);
    }

    const EvenStreamlines& all_;
    const EvenStreamline& line_;
    const std::vector<Shown>& shown_;
    const LineView& lineView_;
    float headPx_, linePart_;
    int levels_;
};

}  // namespace

float spacingIn(const Camera& camera, double spacingPx)
{
    constexpr double usual = 800, least = 8;
    return float(std::max(spacingPx * std::min(camera.width, camera.height) / usual, std::min(spacingPx, least)));
}

void StreamlineStrokes::draw(const View& view, const SeenSurface& seen, Tile& out) const
{
    const StrokeLook look = kLine.in(view.camera);
    const LineView lineView(view, lines_->unitWorld(), spacingIn(view.camera, double(spacingPx_)));
    const int levels = levelsFor(lineView, *lines_);
    if (seen.rows().empty()) return;
    const std::vector<EvenStreamline>& lines = lines_->lines();
    std::vector<std::vector<Stroke>> ofLine(lines.size());
    parallelFor(lines.size(), [&](std::size_t i) {
        if (lines[i].level >= levels) return;
        const std::vector<Shown> shown = shownOf(lines[i], lineView);
        const float linePart = partOfLength(shown, view, look.markPx);
        if (!(linePart > 0)) return;
        addLine(lines[i], shown, lines_->spacing(lines[i].level), lineView, linePart, ofLine[i]);
        Heads(*lines_, lines[i], shown, lineView, look.markPx, linePart, levels).addTo(ofLine[i]);
    });
    StrokeLayer layer{look, {}};
    for (const std::vector<Stroke>& some : ofLine) layer.strokes.insert(layer.strokes.end(), some.begin(), some.end());
    drawStrokes(view, {layer}, seen, out);
}

}  // namespace aeolic
