#pragma once

#include <string>
#include <vector>

namespace aeolic {

/// An array that is to be put together of others, which hold one number each.
struct NamedComponents {
    std::string name;
    std::vector<std::size_t> of;  ///< One or three, or two of a flat file; indices of the names that were given.
};

/// Which axis the component of a vector is of: of two in flat data that lie across an axis, one of the others.
inline std::size_t axisOfComponent(std::size_t component, std::size_t count, std::size_t across)
{
    return count == 2 && component >= across ? component + 1 : component;
}

/// Finds vectors among the names of scalars: "VelocityX VelocityY VelocityZ" is "Velocity", and so are "velocity_x …"
/// and "x-velocity …" in their own spelling, "U V W" is "UVW". In a `flat` file two are enough, those along the axes
/// that it does not lie `across`. Each name is used once; names in no vector stay scalars. Where a vector's name is
/// that of another array, it ends in "XYZ". The order is that of the first components. `counted`: "vel_0 vel_1 vel_2",
/// of which there are no more, is "vel", too.
std::vector<NamedComponents> joinComponents(const std::vector<std::string>& names, bool flat, bool counted = false,
                                            std::size_t across = 2);

}  // namespace aeolic
