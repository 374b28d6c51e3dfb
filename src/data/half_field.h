#pragma once

#include <memory>
#include <vector>

#include "data/tally.h"
#include "data/vector_field.h"

namespace aeolic {

/// The same field in half precision. `field`: floats. The tally counts this part's samples that halves do not hold.
/// Throws InputError where there is no memory for it. Parallel.
std::shared_ptr<const GridField> halfField(const std::shared_ptr<const GridField>& field, std::vector<Tally>& tallies);

}  // namespace aeolic
