#include "render/cpu/lic/fine_cells.h"

#include "base/parallel.h"
#include "render/limits.h"

namespace aeolic::cpu {
namespace {

/// Whether the four pixels of the cell at `links` and those around them are linked to all of theirs.
bool isOpen(const std::uint8_t* links, std::ptrdiff_t stride)
{
    std::uint8_t all = 0xFF;
    for (int row = -limits::kOpenRings; row <= 1 + limits::kOpenRings; ++row)
        for (int column = -limits::kOpenRings; column <= 1 + limits::kOpenRings; ++column)
            all = std::uint8_t(all & links[row * stride + column]);
    return all == 0xFF;
}

}  // namespace

void FineCells::build(const GBuffer& buffer, const FineFlow& from)
{
    flow = &from;
    const Extent& valid = buffer.valid();
    cells.resize(valid);
    noises.resize(valid);
    parallelRows({valid.x0, valid.y0 - 1, valid.x1, valid.y1}, 16, [&](int y) {
        const std::uint32_t *upper = from.vectors.row(y), *lower = from.vectors.row(y + 1);
        const std::uint16_t *upperNoise = from.noise.row(y), *lowerNoise = from.noise.row(y + 1);
        const std::uint8_t* links = buffer.links.row(y);
        FlowCell* cell = cells.row(y);
        std::uint64_t* noise = noises.row(y);
        for (int x = valid.x0 - 1; x < valid.x1; ++x) {
            const std::uint32_t open = isOpen(links + x, buffer.links.stride()) ? 1 : 0;
            cell[x] = {{(upper[x] & ~1U) | open, upper[x + 1], lower[x], lower[x + 1]}};
            noise[x] = std::uint64_t{upperNoise[x]} | std::uint64_t{upperNoise[x + 1]} << 16 |
                       std::uint64_t{lowerNoise[x]} << 32 | std::uint64_t{lowerNoise[x + 1]} << 48;
        }
    });
}

}  // namespace aeolic::cpu
