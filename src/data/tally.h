#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/byte_message.h"

namespace aeolic {

/// How much of a file's data was left out or changed: what there is to warn of. Where several ranks share a scene, each
/// counts in its own part, and every value and triangle is counted by one rank. The sums over all ranks are what one
/// rank would find that holds everything (sumTallies() in data/load/scene_facts.h).
struct Tally {
    enum class Of : char {
        maskedPoints = 'p',  ///< Values at points left blank: `found` masked, `also` not finite.
        maskedCells = 'c',   ///< Values in cells left blank: `found` masked, `also` not finite.
        halves = 'h',        ///< Components too large for half precision, and the longest vector.
        corners = 'k',       ///< Cells left out because a corner is not finite.
        areas = 'a',         ///< Triangles left out because they have no area.
    };
    Of of = Of::maskedPoints;
    std::string where;  ///< The file, or file and array: what its warning begins with.
    std::int64_t found = 0, also = 0;
    std::int64_t all = 0;  ///< How many there are, counted or not.
    double longest = 0;    ///< Least upper bound of the vectors' lengths; 0: not asked.

    /// Whether both count the same thing, perhaps in different parts of the data.
    bool sameThing(const Tally& other) const { return of == other.of && where == other.where; }
    bool operator==(const Tally&) const = default;
};

template <PerhapsConst<Tally> Each, class Visit>
void withMembers(Each& tally, const Visit& visit)
{
    visit(tally.of, tally.where, tally.found, tally.also, tally.all, tally.longest);
}

/// One line each: none where nothing was found.
std::vector<std::string> warningsOf(const Tally& tally);

}  // namespace aeolic
