#include "data/streamlines/line_counts.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/mixed_bits.h"

namespace aeolic {
namespace {

/// Cells beyond are counted as these: far more than a surface has, in units of its size.
constexpr int kMostCells = 1 << 20;

std::uint64_t keyOf(const glm::ivec3& cell)
{
    const auto part = [](int number) { return std::uint64_t(std::uint32_t(number + kMostCells) & 0x1FFFFF); };
    return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);
}

}  // namespace

LineCounts::LineCounts(const std::vector<LineSample>& samples, float reach) : reach_(reach)
{
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(samples.size());
    for (const LineSample& sample : samples) order.emplace_back(keyOf(cellOf(sample.at)), std::uint32_t(order.size()));
    std::ranges::sort(order);
    samples_.reserve(samples.size());
    for (const auto& [key, i] : order) samples_.push_back({samples[i].at, samples[i].normal});
    std::size_t cells = 0;
    for (std::size_t i = 0; i < order.size(); ++i) cells += i == 0 || order[i].first != order[i - 1].first;
    table_.resize(std::bit_ceil(2 * cells + 1));
    for (std::size_t i = 0; i < order.size();) {
        std::size_t end = i;
        while (end < order.size() && order[end].first == order[i].first) ++end;
        std::size_t place = mixedBits(order[i].first) & (table_.size() - 1);
        while (table_[place].end > 0) place = (place + 1) & (table_.size() - 1);
        table_[place] = {order[i].first, std::uint32_t(i), std::uint32_t(end)};
        i = end;
    }
}

glm::ivec3 LineCounts::cellOf(const glm::vec3& at) const
{
    constexpr auto most = float(kMostCells - 2);
    return {glm::clamp(glm::floor(at / reach_), -most, most)};
}

const LineCounts::Cell* LineCounts::find(const glm::ivec3& cell) const
{
    const std::uint64_t key = keyOf(cell);
    std::size_t place = mixedBits(key) & (table_.size() - 1);
    for (; table_[place].end > 0; place = (place + 1) & (table_.size() - 1))
        if (table_[place].key == key) return &table_[place];
    return nullptr;
}

template <class Visit>
void LineCounts::forEachCell(const glm::vec3& at, const Visit& visit) const
{
    const glm::ivec3 middle = cellOf(at);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (const Cell* const cell = find(middle + glm::ivec3(x, y, z))) visit(*cell);
}

std::size_t LineCounts::near(const LineSample& place) const
{
    std::size_t count = 0;
    forEachCell(place.at, [&](const Cell& cell) {
        for (std::uint32_t i = cell.begin; i < cell.end; ++i) {
            const glm::vec3 way = samples_[i].at - place.at;
            count += glm::dot(way, way) < reach_ * reach_ && faceTheSameWay(samples_[i].normal, place.normal);
        }
    });
    return count;
}

std::size_t LineCounts::atMost(const LineSample& place) const
{
    std::size_t count = 0;
    forEachCell(place.at, [&](const Cell& cell) { count += cell.end - cell.begin; });
    return count;
}

}  // namespace aeolic
