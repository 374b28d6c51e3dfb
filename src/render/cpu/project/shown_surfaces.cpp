#include "render/cpu/project/shown_surfaces.h"

#include "base/parallel.h"
#include "render/cpu/project/visibility.h"

namespace aeolic::cpu {

std::vector<std::int32_t> shownSurfaces(const Scene& scene, const View& view, const Extent& rows)
{
    const SurfaceMesh& mesh = scene.surface;
    const SceneArrays arrays(scene);
    Visibility visibility;
    visibility.bin(arrays, view, rows);
    const std::size_t width = std::size_t(rows.width());
    std::vector<std::int32_t> shown(width * std::size_t(rows.height()), -1);
    parallelFor(std::size_t(visibility.tiles()), [&](std::size_t i) {
        thread_local TileKeys keys;
        if (!visibility.draw(int(i), keys)) return;
        const Extent tile = visibility.tileExtent(int(i));
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                const std::uint64_t key = keys.key[y - tile.y0][x - tile.x0];
                if (key == 0) continue;
                shown[std::size_t(y - rows.y0) * width + std::size_t(x - rows.x0)] =
                    mesh.surfaceOf[mesh.triangles[TileKeys::triangle(key)][0]];
            }
    });
    return shown;
}

}  // namespace aeolic::cpu
