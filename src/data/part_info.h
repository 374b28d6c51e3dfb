#pragma once

#include <string>
#include <vector>

#include "base/byte_message.h"

namespace aeolic {

/// A part of a file, before it is read.
struct PartInfo {
    std::string name;                 ///< "terrain", or "air/walls/left" where parts stand in others.
    std::string type;                 ///< What it is, as `aeolic info` says it: "zone", "side set", "BCWall".
    std::vector<std::string> groups;  ///< Other names that it goes by together with others.
    int dimension = 3;                ///< 3: it fills space; 2: it is faces.
    bool usual = true;                ///< Drawn where no part is named, if it is faces.
    bool derived = false;             ///< Its cells are faces of another part.
};

template <PerhapsConst<PartInfo> Part, class Visit>
void withMembers(Part& part, const Visit& visit)
{
    visit(part.name, part.type, part.groups, part.dimension, part.usual, part.derived);
}

}  // namespace aeolic
