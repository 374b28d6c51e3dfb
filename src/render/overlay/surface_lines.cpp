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
    return strokes;
}

}  // namespace

void SurfaceLines::draw(const View& view, const SeenSurface& seen, Tile& out) const
{
    if (seen.rows().empty()) return;
    std::vector<StrokeLayer> layers;
    for (const Style& style : styles_) layers.push_back({style.look.in(view.camera), strokesOf(view, style)});
    drawStrokes(view, layers, seen, out);
}

}  // namespace aeolic
