#include "stages/frame_stages.h"

#include "base/timing.h"
#include "render/limits.h"

namespace aeolic {

StageTimes startStages(const FrameRequest& request, const Scene& scene, Backend& backend, Tile& out)
{
    const View view = makeView(request.camera, scene, request.lic);
    const LicOptions lic = inShortSteps(request.lic, view);
    const Palette palette = paletteOf(request, scene);
    const Extent whole{0, 0, request.camera.width, request.camera.height};
    const int edgeRows = palette.antialias ? limits::kEdgeRows : 0;
    StageTimes times;
    StopWatch watch;
    backend.project(view, whole);
    times.projectMs = watch.lapMs();
    backend.convolve(lic, whole);
    backend.smooth(lic, whole, nullptr, edgeRows);
    backend.flatten(lic, whole, nullptr, edgeRows);
    times.convolveMs = watch.lapMs();
    backend.occlude(palette, whole, nullptr, edgeRows);
    backend.shade(palette, whole, out);
    times.shadeMs = watch.lapMs();
    return times;
}

}  // namespace aeolic
