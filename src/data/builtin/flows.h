#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/bounds.h"
#include "data/vector_field.h"
#include "description/builtin_names.h"

namespace aeolic {

/// The velocity of built-in flow `name` at a point, for a box of the given bounds; all share the box's centre c.
///
/// - abc: Arnold-Beltrami-Childress, A = sqrt 3, B = sqrt 2, C = 1; 1.25 periods along the longest side.
/// - tornado: a vortex around z whose core wanders and widens with height; air is drawn in below and rises in the core.
/// - rotation: (0, 0, 1) x (p - c).
/// - uniform: (1, 0, 0).
/// - gyre: the unsteady double gyre (shadden2005lcs, section 6), A = 0.1, epsilon = 0.25, period 10. Its unit box,
///   2 wide and 1 high, is stretched to the box's x and y, and its velocity with it; it is alike at every z. The other
///   flows do not change in time.
///
/// Throws InputError for an unknown name.
glm::dvec3 builtinFlow(const std::string& name, const glm::dvec3& pointWorld, const Bounds& boundsWorld,
                       double time = 0);

/// Moments to choose from, over a period; none for a flow that does not change. Any other moment can be had as well.
std::vector<double> builtinFlowTimes(const std::string& spec);

/// `NAME[:NX,NY,NZ]` sampled on a grid of float vectors whose first and last samples lie on the bounds; 128 x 128 x 128
/// by default, each from 2 to 4096. A flat side of the bounds (a plane's z) is given a thousandth of the longest side,
/// half to each side, so that the spacing stays positive. Where it is split, only the brick of `part` is made; its
/// samples have the same bits as in the whole.
///
/// Throws InputError for a bad `spec` or a grid larger than the available memory, before anything is allocated;
/// std::invalid_argument for empty or non-finite bounds. Cost: parallel, one pass of writing, 12 bytes a sample.
std::shared_ptr<const GridField> makeBuiltinFlow(const std::string& spec, const Bounds& boundsWorld,
                                                 const FieldPart& part = {}, double time = 0);

/// The whole grid without samples, as far as it is known before the box is. Throws InputError for a bad `spec`.
GridField outlineOfBuiltinFlow(const std::string& spec);

}  // namespace aeolic
