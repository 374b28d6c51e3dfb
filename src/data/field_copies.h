#pragma once

#include <memory>
#include <vector>

#include "data/tally.h"
#include "data/vector_field.h"

// What is made of a field whose samples are floats, on the same grid. Both throw InputError where there is no memory
// for it, and are parallel.
namespace aeolic {

/// One component of a field of vectors, as a scalar on its grid. The vectors do not lie in tiles.
std::shared_ptr<const GridField> componentOf(const GridField& vectors, int component);

/// A copy of a field of floats in half precision. `tallies` gets one more entry: how many samples of this part of the
/// field are too large for that.
std::shared_ptr<const GridField> halfField(const std::shared_ptr<const GridField>& field, std::vector<Tally>& tallies);

}  // namespace aeolic
