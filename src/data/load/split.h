#pragma once

#include "aeolic/data.h"
#include "aeolic/scene_description.h"
#include "data/load/agreement.h"

namespace aeolic {

/// What of a scene is split among the ranks.
struct Split {
    bool field = false;    ///< The field is split into bricks, and an isosurface of it into the pieces in them.
    bool surface = false;  ///< A surface from a file is split into that file's pieces. Where the field is split too,
                           ///< every rank then gets the triangles that reach into its brick.
    int ranksOnHost = 1;   ///< That share this host's memory.
    bool any() const { return field || surface; }
};

/// Collective. What of the scene is split: by `description.run.bricks` all that can be, or nothing. By default it is
/// what the ranks of some host would have no memory for otherwise. `ranksOnHost`: the ranks that share this host's
/// memory. A surface in memory is in pieces always, a grid in memory never. Throws InputError.
Split splitOf(const SceneDescription& description, Agreement& agreement, int ranksOnHost, const Data& memory = {});

}  // namespace aeolic
