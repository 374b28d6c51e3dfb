#include "pipeline/frame.h"

#include "base/timing.h"

namespace aeolic {
namespace {

std::int64_t countCovered(const GBuffer& buffer, const Extent& rows)
{
    std::int64_t count = 0;
    for (int y = rows.y0; y < rows.y1; ++y) {
        const float* depth = buffer.invDepth.row(y);
        for (int x = rows.x0; x < rows.x1; ++x) count += depth[x] > 0;
    }
    return count;
}

}  // namespace

Tile renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameStats& stats, Tile reuse)
{
    StopWatch whole, stage;
    const double busyBefore = processCpuMs();
    const Extent rows{0, 0, request.camera.width, request.camera.height};
    const View view = makeView(request.camera, scene, request.lic);
    const Palette palette = makePalette(request.shading, scene.hasScalar, scene.scalarRange);
    Tile tile = std::move(reuse);
    tile.resize(rows);

    GBuffer& visible = backend.project(view, rows);  // Surface and field to pixels.
    stats.projectMs = stage.lapMs();
    const Image<float>& lic = backend.convolve(visible, request.lic, rows);  // Noise along streamlines.
    stats.convolveMs = stage.lapMs();
    backend.shade(visible, lic, palette, rows, tile);  // LIC, light and colour to the picture.
    stats.shadeMs = stage.lapMs();

    stats.totalMs = whole.lapMs();
    stats.busyMs = processCpuMs() - busyBefore;
    stats.coveredPixels = countCovered(visible, rows);
    return tile;
}

}  // namespace aeolic
