#include "data/load/field/brick_sampler.h"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <tuple>

#include "data/surface_range.h"

namespace aeolic {
namespace {

bool isBefore(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The places of all ranks, one after the other. `first` becomes where this rank's begin.
std::vector<double> placesOfAll(Agreement& agreement, const std::vector<glm::dvec3>& mine, std::size_t& first)
{
    const FieldPart part = agreement.part();
    std::vector<double> counts(std::size_t(part.ranks), 0.0);
    counts[std::size_t(part.rank)] = double(mine.size());
    agreement.sum(counts);
    std::size_t all = 0;
    for (std::size_t rank = 0; rank < counts.size(); ++rank) {
        if (rank == std::size_t(part.rank)) first = all;
        all += std::size_t(counts[rank]);
    }
    std::vector<double> places(3 * all, 0.0);
    for (std::size_t i = 0; i < mine.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) places[3 * (first + i) + c] = mine[i][int(c)];
    agreement.sum(places);
    return places;
}

std::vector<double> flat(const std::vector<glm::dvec3>& places)
{
    std::vector<double> numbers;
    numbers.reserve(3 * places.size());
    for (const glm::dvec3& place : places) numbers.insert(numbers.end(), {place.x, place.y, place.z});
    return numbers;
}

}  // namespace

BrickSampler::BrickSampler(std::shared_ptr<const GridField> vectors, std::shared_ptr<const GridField> scalars,
                           double longest)
    : grid_(vectors, scalars), vectors_(std::move(vectors)), scalars_(std::move(scalars)), longest_(longest)
{
}

bool BrickSampler::findWithin(const glm::dvec3& pointWorld, CellPlace& place) const
{
    return grid_.findWithin(pointWorld, place);
}

bool BrickSampler::find(const glm::dvec3& pointWorld, const glm::dvec3& towards, CellPlace& place) const
{
    return grid_.find(pointWorld, towards, place);
}

double BrickSampler::heightOver(const CellPlace& place, const glm::dvec3& pointWorld, const glm::dvec3& normal) const
{
    return grid_.heightOver(place, pointWorld, normal);
}

double BrickSampler::widthOf(const CellPlace& place, const glm::dvec3& direction) const
{
    return grid_.widthOf(place, direction);
}

glm::dvec3 BrickSampler::vectorAt(const CellPlace& place) const
{
    const Values values = valuesAt(place);
    return {values[0], values[1], values[2]};
}

double BrickSampler::scalarAt(const CellPlace& place) const
{
    return valuesAt(place)[3];
}

BrickSampler::Values BrickSampler::valuesAt(const CellPlace& place) const
{
    const glm::dvec3 at = grid_.pointOf(place);
    if (!answers_) {
        const std::lock_guard lock(asking_);
        places_.push_back(at);
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        return {unknown, unknown, unknown, unknown};
    }
    const auto found = std::lower_bound(places_.begin(), places_.end(), at, isBefore);
    if (found == places_.end() || *found != at) throw std::logic_error("a place of a brick was not asked for");
    return known_[std::size_t(found - places_.begin())];
}

/// Zeros where another rank knows it.
BrickSampler::Values BrickSampler::ownValuesAt(const glm::dvec3& pointWorld) const
{
    const FieldVector vector = aeolic::vectorAt(*vectors_, pointWorld);
    if (!vector.inside || vector.elsewhere) return {};
    const double scalar = scalars_ ? aeolic::vectorAt(*scalars_, pointWorld).vector.x : 0.0;
    return {vector.vector.x, vector.vector.y, vector.vector.z, scalar};
}

void BrickSampler::ask(Agreement& agreement, bool samePlaces)
{
    std::sort(places_.begin(), places_.end(), isBefore);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    std::size_t first = 0;
    const std::vector<double> places = samePlaces ? flat(places_) : placesOfAll(agreement, places_, first);
    std::vector<double> values(places.size() / 3 * 4);
    for (std::size_t i = 0; i < places.size() / 3; ++i) {
        const Values own = ownValuesAt({places[3 * i], places[3 * i + 1], places[3 * i + 2]});
        std::copy(own.begin(), own.end(), values.begin() + std::ptrdiff_t(4 * i));
    }
    agreement.sum(values);  // Of each place one rank alone has other terms than zero, so this rounds nothing.
    known_.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i)
        std::copy_n(values.begin() + std::ptrdiff_t(4 * (first + i)), 4, known_[i].begin());
    answers_ = true;
}

}  // namespace aeolic
