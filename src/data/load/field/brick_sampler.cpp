#include "data/load/field/brick_sampler.h"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <tuple>

#include "base/append.h"
#include "base/byte_message.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

bool isBefore(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The places of all ranks, one after the other. `first` becomes where this rank's begin.
std::vector<glm::dvec3> placesOfAll(Agreement& agreement, const std::vector<glm::dvec3>& mine, std::size_t& first)
{
    ByteWriter writer;
    writer.add(mine);
    const std::vector<Bytes> all = agreement.gatherAll(writer.take());
    std::vector<glm::dvec3> places, some;
    for (std::size_t rank = 0; rank < all.size(); ++rank) {
        if (rank == std::size_t(agreement.part().rank)) first = places.size();
        ByteReader(all[rank]).read(some);
        appendAll(places, some);
    }
    return places;
}

}  // namespace

BrickSampler::BrickSampler(std::shared_ptr<const GridField> vectors, std::shared_ptr<const GridField> scalars,
                           double longest)
    : GridSampler(std::move(vectors), std::move(scalars)), longest_(longest)
{
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
    const glm::dvec3 at = pointOf(place);
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
    std::ranges::sort(places_, isBefore);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    std::size_t first = 0;
    const std::vector<glm::dvec3> places = samePlaces ? places_ : placesOfAll(agreement, places_, first);
    std::vector<double> values(4 * places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        std::ranges::copy(ownValuesAt(places[i]), values.begin() + std::ptrdiff_t(4 * i));
    agreement.sum(values);  // Of each place one rank alone has other terms than zero, so this rounds nothing.
    known_.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i)
        std::copy_n(values.begin() + std::ptrdiff_t(4 * (first + i)), 4, known_[i].begin());
    answers_ = true;
}

}  // namespace aeolic
