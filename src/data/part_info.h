#pragma once

#include <string>
#include <vector>

namespace aeolic {

/// A part of a file, before it is read.
struct PartInfo {
    std::string name;
    std::string type;                 ///< What it is, as `aeolic info` says it: "zone", "side set", "BCWall".
    std::vector<std::string> groups;  ///< Other names that it goes by together with others.
    int dimension = 3;                ///< 3: it fills space; 2: it is faces.
    bool usual = true;                ///< Drawn where no part is named, if it is faces.
    bool derived = false;             ///< Its cells are faces of another part.
};

}  // namespace aeolic
