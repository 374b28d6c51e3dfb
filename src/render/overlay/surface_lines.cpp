#include "render/overlay/surface_lines.h"

namespace aeolic {
namespace {

std::vector<Stroke> strokesOf(const View& view, const SurfaceLines::Style& style)
{
    std::vector<Stroke> strokes;
    for (const std::vector<glm::vec3>& line : style.lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (const auto stroke = strokeOf(view, fromEye(view, line[i]), fromEye(view, line[i + 1])))
                strokes.push_back(*stroke);
    for (const SurfaceLines::Mark& mark : style.marks)
        if (const glm::vec3 way = fromEye(view, mark.at); way.z >= float(view.nearDepth))
            strokes.push_back({strokeEnd(view, way), strokeEnd(view, way), mark.shape});
    for (const SurfaceLines::Head& head : style.heads) {
        const glm::vec3 from = fromEye(view, head.from), to = fromEye(view, head.to);
        if (!(from.z >= float(view.nearDepth) && to.z >= float(view.nearDepth))) continue;
        const StrokeEnd tip = strokeEnd(view, to);
        const glm::vec2 way = tip.px - strokeEnd(view, from).px;
        if (!(glm::length(way) > 1e-3f)) continue;  // Seen from ahead or behind.
        strokes.push_back({tip, tip, MarkShape::head});
        strokes.back().b.px += glm::normalize(way);
    }
    return strokes;
}

}  // namespace

void addHeads(const std::vector<glm::vec3>& line, double apart, SurfaceLines::Style& style)
{
    double passed = 0.5 * apart;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double way = glm::length(glm::dvec3(line[i]) - glm::dvec3(line[i - 1]));
        passed += way;
        if (passed < apart || !(way > 0)) continue;
        passed = 0;
        style.heads.push_back({line[i - 1], line[i]});
    }
}

void SurfaceLines::draw(const View& view, const SeenSurface& seen, Tile& out) const
{
    if (seen.rows().empty()) return;
    std::vector<StrokeLayer> layers;
    for (const Style& style : styles_) layers.push_back({style.look.in(view.camera), strokesOf(view, style)});
    drawStrokes(view, layers, seen, out);
}

}  // namespace aeolic
