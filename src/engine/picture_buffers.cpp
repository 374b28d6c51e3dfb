#include "engine/picture_buffers.h"

#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "render/cpu/project/visibility.h"

namespace aeolic {
namespace {

constexpr float kUntold = std::numeric_limits<float>::quiet_NaN();

/// Calls visit(list) for each list of numbers, always in the same order.
template <class Buffers, class Visit>
void forEachList(Buffers& buffers, const Visit& visit)
{
    visit(buffers.depth);
    visit(buffers.normal);
    visit(buffers.flow);
    visit(buffers.lic);
    visit(buffers.scalar);
    visit(buffers.surface);
}

/// Which of several surfaces the pixels of some rows show, in Scene::surfaces' order; -1: none. [pixels of `rows`], row
/// after row. Cost: that of finding what is visible in a frame, and of rearranging the scene for it.
std::vector<std::int32_t> shownSurfaces(const Scene& scene, const View& view, const Extent& rows)
{
    const SurfaceMesh& mesh = scene.surface;
    const cpu::SceneArrays arrays(scene);
    cpu::Visibility visibility;
    visibility.bin(arrays, view, rows);
    const std::size_t width = std::size_t(rows.width());
    std::vector<std::int32_t> shown(width * std::size_t(rows.height()), -1);
    parallelFor(std::size_t(visibility.tiles()), [&](std::size_t i) {
        thread_local cpu::TileKeys keys;
        if (!visibility.draw(int(i), keys)) return;
        const Extent tile = visibility.tileExtent(int(i));
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                const std::uint64_t key = keys.key[y - tile.y0][x - tile.x0];
                if (key == 0) continue;
                shown[std::size_t(y - rows.y0) * width + std::size_t(x - rows.x0)] =
                    mesh.surfaceOf[mesh.triangles[cpu::TileKeys::triangle(key)][0]];
            }
    });
    return shown;
}

}  // namespace

PictureBuffers buffersOf(Backend& backend, const View& view, const Scene& scene, const Extent& rows)
{
    PictureBuffers out;
    out.width = rows.width();
    out.height = rows.height();
    const std::size_t pixels = std::size_t(rows.width()) * std::size_t(rows.height());
    out.depth.assign(pixels, kUntold);
    out.normal.assign(3 * pixels, kUntold);
    out.flow.assign(2 * pixels, kUntold);
    out.lic.assign(pixels, kUntold);
    if (scene.hasScalar) out.scalar.assign(pixels, kUntold);
    if (pixels == 0) return out;
    const bool several = !scene.surface.surfaceOf.empty();
    out.surface = several ? shownSurfaces(scene, view, rows) : std::vector<std::int32_t>(pixels, 0);
    SeenSurface seen;
    backend.see(rows, seen);
    const Image<float>& lic = backend.probe().lic();
    const Image<float>& scalar = backend.probe().gbuffer().scalar;
    parallelFor(std::size_t(rows.height()), [&](std::size_t row) {
        const int y = rows.y0 + int(row);
        std::size_t i = row * std::size_t(rows.width());
        for (int x = rows.x0; x < rows.x1; ++x, ++i) {
            if (!seen.covered(x, y)) {
                out.surface[i] = -1;
                continue;
            }
            out.depth[i] = float(seen.depth(view, x, y));
            const glm::vec3 normal = seen.normal(view, x, y);
            for (int c = 0; c < 3; ++c) out.normal[3 * i + std::size_t(c)] = normal[c];
            if (scene.hasScalar) out.scalar[i] = scalar.at(x, y);
            const auto step = seen.step(x, y);
            if (!step) continue;
            out.flow[2 * i] = step->x;
            out.flow[2 * i + 1] = step->y;
            out.lic[i] = lic.at(x, y);
        }
    });
    return out;
}

PictureBuffers gathered(const PictureBuffers& mine, Communicator& ranks)
{
    PictureBuffers all;
    if (ranks.isRoot()) all.width = mine.width;
    std::vector<std::vector<Bytes>> ofRanks;
    forEachList(mine, [&](const auto& list) { ofRanks.push_back(ranks.gather(std::as_bytes(std::span(list)))); });
    std::size_t which = 0;
    forEachList(all, [&](auto& list) {
        for (const Bytes& bytes : ofRanks[which]) {
            const std::size_t before = list.size();
            list.resize(before + bytes.size() / sizeof list[0]);
            if (!bytes.empty()) std::memcpy(list.data() + before, bytes.data(), bytes.size());
        }
        ++which;
    });
    if (all.width > 0) all.height = int(all.depth.size() / std::size_t(all.width));
    return all;
}

}  // namespace aeolic
