#pragma once

#include <memory>
#include <vector>

#include "data/tally.h"
#include "data/vector_field.h"

namespace aeolic {

/// A copy of `field`, whose samples are floats, in half precision. `tallies` gets one more entry: how many
/// samples of this part of the field are too large for that.
/// Throws InputError where there is no memory for it. Parallel.
std::shared_ptr<const GridField> halfField(const std::shared_ptr<const GridField>& field, std::vector<Tally>& tallies);

}  // namespace aeolic
