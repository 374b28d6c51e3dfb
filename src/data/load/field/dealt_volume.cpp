#include "data/load/field/dealt_volume.h"

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "base/byte_message.h"
#include "data/cells/volume_message.h"
#include "data/load/scene_facts.h"

namespace aeolic {

template <PerhapsConst<SurfaceZone> Zone, class Visit>
void withMembers(Zone& zone, const Visit& visit)
{
    visit(zone.triangles, zone.reachWorld);
}

namespace {

using Shell = CellVolume::Shell;

Shell noCells(const DealtVolume& volume)
{
    Shell shell;
    shell.cells.name = volume.name;
    shell.cells.maxVector = volume.maxVector;
    shell.cells.meansOfCells = volume.meansOfCells;
    shell.cells.first.push_back(0);
    return shell;
}

/// A message of this rank's cells near the zone.
Bytes ownCells(const DealtVolume& volume, const SurfaceZone& zone, double diagonals)
{
    ByteWriter writer;
    if (volume.own.empty() || zone.triangles.empty()) return writer.take();
    NearSurface surface(zone);
    for (const auto& piece : volume.own) {
        const Shell shell = piece->near(surface, diagonals);
        writer.add(shell.leftOut.least());
        writer.add(messageOf(shell.cells));
    }
    return writer.take();
}

void append(Shell& shell, const Bytes& message)
{
    ByteReader reader(message);
    while (!reader.atEnd()) {
        double leastLeftOut = 0;
        std::span<const std::byte> cells;
        reader.read(leastLeftOut);
        reader.read(cells);
        shell.leftOut.addAnywhere(leastLeftOut);
        appendCells(cells, shell.cells);
    }
}

SurfaceZone zoneOf(const Bytes& message)
{
    SurfaceZone zone(std::vector<glm::dvec3>{}, {});
    ByteReader(message).read(zone);
    return zone;
}

}  // namespace

std::shared_ptr<const DealtVolume> DealtVolume::copy() const
{
    auto copied = std::make_shared<DealtVolume>(*this);
    for (auto& piece : copied->own) piece = piece->copy();
    return copied;
}

std::shared_ptr<const DealtVolume> dealtVolume(std::vector<std::shared_ptr<const CellVolume>> own, bool everywhere,
                                               const std::string& name, Agreement& agreement)
{
    auto volume = std::make_shared<DealtVolume>();
    volume->own = std::move(own);
    volume->everywhere = everywhere;
    volume->name = name;
    agreement.together([&] {
        for (const auto& piece : volume->own) {
            volume->boundsWorld.add(piece->bounds());
            volume->maxVector = std::max(volume->maxVector, piece->maxVector());
            volume->cells += piece->count();
            volume->meansOfCells = volume->meansOfCells || piece->meansOfCells();
        }
    });
    uniteBounds(agreement, volume->boundsWorld);
    agreement.together([&] {
        if (volume->boundsWorld.empty())
            throw InputError(name, "none of its cells has a volume and finite corners", "a 3D field to sample");
    });
    volume->maxVector = agreement.greatest(volume->maxVector);
    if (!everywhere) volume->cells = std::uint64_t(agreement.sum(std::int64_t(volume->cells)));
    volume->meansOfCells = agreement.any(volume->meansOfCells);
    return volume;
}

Shell shellAround(const DealtVolume& volume, SurfaceZone zone, double diagonals, bool inPieces, Agreement& agreement)
{
    Shell shell = noCells(volume);
    if (volume.everywhere) {
        agreement.together([&] {
            if (volume.own.size() == 1) {
                NearSurface surface(std::move(zone));
                shell = volume.own.front()->near(surface, diagonals);
            } else {
                append(shell, ownCells(volume, zone, diagonals));
            }
        });
        return shell;
    }
    // A rank with a piece of the surface gets the cells near it. Ranks take turns, so that none holds all cells.
    const int rounds = inPieces ? agreement.part().ranks : 1;
    for (int rank = 0; rank < rounds; ++rank) {
        const bool mine = !inPieces || rank == agreement.part().rank;
        Bytes asked;
        if (inPieces) asked = agreement.gatherAll(mine ? byteMessage(zone) : Bytes{})[std::size_t(rank)];
        Bytes cells;
        agreement.together([&] { cells = ownCells(volume, inPieces ? zoneOf(asked) : zone, diagonals); });
        const std::vector<Bytes> all = agreement.gatherAll(std::move(cells));
        agreement.together([&] {
            if (!mine) return;
            for (const Bytes& some : all) append(shell, some);
        });
    }
    return shell;
}

}  // namespace aeolic
