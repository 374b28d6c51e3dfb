#pragma once

#include <fmt/format.h>

#include <string>

namespace aeolic {

/// The warning where `blank` of `pictures` show nothing of the surface.
inline std::string nothingShown(int blank, int pictures)
{
    return (pictures == 1 ? "the picture shows" : fmt::format("{} of {} pictures show", blank, pictures)) +
           std::string(" nothing of the surface: it is beside the view, behind it, or flat and seen from its edge; ") +
           "another --camera may help";
}

}  // namespace aeolic
