#include "data/field_tiles.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/large_memory.h"
#include "base/memory.h"
#include "base/parallel.h"

namespace aeolic {

namespace {

constexpr std::size_t worthwhileBytes = std::size_t{32} << 20;
constexpr std::int64_t mostGroupBytes = std::int64_t{2} << 30;  // A group is held twice while it is put in order.
constexpr std::size_t grain = 16;                               // Rows.

std::int64_t groupBytes(const GridField& field)
{
    const GridIndex held = field.heldDims();
    return held[0] * held[1] * std::min(FieldTiles::kLayers, held[2]) * std::int64_t(field.sampleBytes());
}

/// Calls visit(first sample in the row, samples, index of the first) for the parts of row (y, z) that lie together.
template <class Visit>
void forEachPart(const GridIndex& held, std::int64_t y, std::int64_t z, const Visit& visit)
{
    for (std::int64_t x = 0; x < held[0]; x += FieldTiles::kWidth)
        visit(std::size_t(x), std::size_t(std::min(FieldTiles::kWidth, held[0] - x)),
              std::size_t(FieldTiles::index(held, x, y, z)));
}

}  // namespace

bool worthTiling(const GridField& field)
{
    return field.components == 3 && field.bytes() >= worthwhileBytes && groupBytes(field) <= mostGroupBytes &&
           field.sampleCount() <= std::numeric_limits<std::uint32_t>::max();  // Kernels count samples in 32 bits.
}

void toTiles(GridField& field)
{
    if (field.tiled) return;
    const GridIndex held = field.heldDims();
    const std::size_t bytes = field.sampleBytes();
    requireMemory(field.name, "the layers of the field that are put in order at once",
                  std::uint64_t(groupBytes(field)));
    const LargeArray<std::byte> rows = makeLargeArray<std::byte>(std::size_t(groupBytes(field)));
    auto* const samples = static_cast<std::byte*>(const_cast<void*>(field.samples.get()));
    const std::size_t rowBytes = std::size_t(held[0]) * bytes;
    for (std::int64_t first = 0; first < held[2]; first += FieldTiles::kLayers) {
        const std::int64_t layers = std::min(FieldTiles::kLayers, held[2] - first);
        const auto count = std::size_t(layers * held[1]);
        const std::byte* const group = samples + std::size_t(first * held[1]) * rowBytes;
        const auto forEachRow = [&](const auto& body) {
            parallelRanges(count, grain, [&](std::size_t begin, std::size_t end) {
                for (std::size_t row = begin; row < end; ++row) body(row, rows.get() + row * rowBytes);
            });
        };
        forEachRow([&](std::size_t row, std::byte* kept) { std::memcpy(kept, group + row * rowBytes, rowBytes); });
        forEachRow([&](std::size_t row, const std::byte* kept) {
            const std::int64_t y = std::int64_t(row) % held[1], z = first + std::int64_t(row) / held[1];
            forEachPart(held, y, z, [&](std::size_t x, std::size_t width, std::size_t index) {
                std::memcpy(samples + index * bytes, kept + x * bytes, width * bytes);
            });
        });
    }
    field.tiled = true;
}

std::shared_ptr<const GridField> inTiles(const std::shared_ptr<const GridField>& field)
{
    if (!worthTiling(*field)) return field;
    auto tiled = std::make_shared<GridField>(*field);
    toTiles(*tiled);
    return tiled;
}

void copyRow(const GridField& field, std::int64_t y, std::int64_t z, std::byte* out)
{
    const GridIndex held = field.heldDims();
    const std::size_t bytes = field.sampleBytes();
    const auto* const samples = static_cast<const std::byte*>(field.samples.get());
    if (!field.tiled) {
        const std::size_t rowBytes = std::size_t(held[0]) * bytes;
        std::memcpy(out, samples + std::size_t(z * held[1] + y) * rowBytes, rowBytes);
        return;
    }
    forEachPart(held, y, z, [&](std::size_t x, std::size_t width, std::size_t index) {
        std::memcpy(out + x * bytes, samples + index * bytes, width * bytes);
    });
}

}  // namespace aeolic
