#include "data/streamlines/near_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace aeolic {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Cells beyond are counted as these: far more than a surface has, in units of its size.
constexpr float kFarthestCell = 1 << 30;

}  // namespace

NearSamples::NearSamples(float reach, std::size_t expected)
    : cell_(2 * reach), first_(std::bit_ceil(std::max<std::size_t>(expected, 1024)), kNone)
{
    samples_.reserve(expected);
}

glm::ivec3 NearSamples::cellOf(const glm::vec3& at) const
{
    return {glm::clamp(glm::floor(at / cell_), -kFarthestCell, kFarthestCell)};
}

std::size_t NearSamples::bucketOf(const glm::ivec3& cell) const
{
    const auto mixed = std::uint64_t(std::uint32_t(cell.x)) * 0x9E3779B97F4A7C15u ^
                       std::uint64_t(std::uint32_t(cell.y)) * 0xC2B2AE3D27D4EB4Fu ^
                       std::uint64_t(std::uint32_t(cell.z)) * 0x165667B19E3779F9u;
    return std::size_t(mixed >> 20) & (first_.size() - 1);
}

void NearSamples::add(const LineSample& sample)
{
    std::uint32_t& first = first_[bucketOf(cellOf(sample.at))];
    samples_.push_back({sample, first});
    first = std::uint32_t(samples_.size() - 1);
}

void NearSamples::shrinkTo(std::size_t count)
{
    for (; samples_.size() > count; samples_.pop_back())
        first_[bucketOf(cellOf(samples_.back().sample.at))] = samples_.back().next;
}

bool NearSamples::isFree(const LineSample& place, float radius, float ownArc) const
{
    const glm::ivec3 low = cellOf(place.at - radius), high = cellOf(place.at + radius);
    glm::ivec3 cell;
    for (cell.z = low.z; cell.z <= high.z; ++cell.z)
        for (cell.y = low.y; cell.y <= high.y; ++cell.y)
            for (cell.x = low.x; cell.x <= high.x; ++cell.x)
                for (std::uint32_t i = first_[bucketOf(cell)]; i != kNone; i = samples_[i].next) {
                    const LineSample& other = samples_[i].sample;
                    const glm::vec3 way = other.at - place.at;
                    if (!(glm::dot(way, way) < radius * radius) || !faceTheSameWay(other.normal, place.normal))
                        continue;
                    if (other.chain != place.chain || std::abs(other.arc - place.arc) > ownArc) return false;
                }
    return true;
}

}  // namespace aeolic
