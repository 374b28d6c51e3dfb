#pragma once

#include <string>
#include <vector>

namespace aeolic {

/// An array that is to be put together of others, which hold one number each.
struct NamedComponents {
    std::string name;
    std::vector<std::size_t> of;  ///< One or three, or two of a flat file; indices of the names that were given.
};

/// Finds vectors among the names of scalars: "VelocityX VelocityY VelocityZ" is "Velocity", and so are "velocity_x …"
/// and "x-velocity …" in their own spelling, "U V W" is "UVW". In a `flat` file two are enough. Each name is used once;
/// names in no vector stay scalars. Where a vector's name is that of another array, it ends in "XYZ". The order is
/// that of the first components.
std::vector<NamedComponents> joinComponents(const std::vector<std::string>& names, bool flat);

}  // namespace aeolic
