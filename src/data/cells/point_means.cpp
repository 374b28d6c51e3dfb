#include "data/cells/point_means.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include "base/byte_message.h"
#include "base/same_place.h"

namespace aeolic {
namespace {

/// What is known of one place.
struct Common {
    std::size_t lastPiece = 0;
    std::uint32_t pieces = 0;
    std::uint64_t cells = 0;
    std::uint8_t dimension = 0;  // Of the cells.
    bool twice = false;          // In one piece.
};

}  // namespace

template <PerhapsConst<PointMeans> Means, class Visit>
void withMembers(Means& means, const Visit& visit)
{
    visit(means.placesWorld, means.points, means.cells, means.dimensions, means.width, means.values);
}

Bytes messageOf(const PointMeans& means)
{
    return byteMessage(means);
}

PointMeans meansOf(std::span<const std::byte> message)
{
    PointMeans means;
    ByteReader reader(message);
    reader.read(means);
    const std::size_t places = means.placesWorld.size();
    if (means.points.size() != places || means.cells.size() != places || means.dimensions.size() != places ||
        means.values.size() != places * means.width || !reader.atEnd())
        throw std::runtime_error("a message of means at points is malformed");
    return means;
}

void uniteMeans(std::span<PointMeans> pieces)
{
    std::unordered_map<glm::dvec3, std::size_t, SamePlace> known;
    std::vector<Common> common;
    std::vector<double> sums;  // [common * width] Of all cells' values.
    std::uint32_t width = 0;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        const PointMeans& means = pieces[piece];
        if (means.placesWorld.empty()) continue;
        if (width == 0) width = means.width;
        if (means.width != width) throw std::runtime_error("pieces of a mesh have different arrays");
        for (std::size_t i = 0; i < means.placesWorld.size(); ++i) {
            const std::size_t at = known.try_emplace(means.placesWorld[i], common.size()).first->second;
            if (at == common.size()) {
                common.emplace_back();
                sums.resize(sums.size() + width, 0.0);
            }
            Common& place = common[at];
            place.twice = place.twice || (place.pieces > 0 && place.lastPiece == piece);
            place.lastPiece = piece;
            ++place.pieces;
            if (means.dimensions[i] < place.dimension) continue;
            if (means.dimensions[i] > place.dimension) {
                place.dimension = means.dimensions[i];
                place.cells = 0;
                std::fill_n(sums.begin() + std::ptrdiff_t(at * width), width, 0.0);
            }
            place.cells += means.cells[i];
            for (std::size_t k = 0; k < width; ++k)
                sums[at * width + k] += double(means.cells[i]) * double(means.values[i * width + k]);
        }
    }
    for (PointMeans& means : pieces)
        for (std::size_t i = 0; i < means.placesWorld.size(); ++i) {
            const std::size_t at = known.at(means.placesWorld[i]);
            const Common& place = common[at];
            if (place.pieces < 2 || place.twice || place.cells == 0) continue;
            for (std::size_t k = 0; k < width; ++k)
                means.values[i * width + k] = float(sums[at * width + k] / double(place.cells));
        }
}

}  // namespace aeolic
