#pragma once

/// The names of surfaces and flows that need no file. data/builtin makes them.

#include <algorithm>
#include <iterator>
#include <string_view>

namespace aeolic {

inline constexpr std::string_view builtinSurfaceNames[] = {"teapot", "sphere", "torus", "plane", "wave"};
inline constexpr std::string_view builtinFlowNames[] = {"abc", "tornado", "rotation", "uniform", "gyre"};

/// The part of a spec before its ':', or all of it.
inline std::string_view nameInSpec(std::string_view spec)
{
    return spec.substr(0, spec.find(':'));
}

/// Whether `spec` is one of those names, alone or followed by ':'. What follows the colon is not looked at.
inline bool isBuiltinSurface(std::string_view spec)
{
    return std::count(std::begin(builtinSurfaceNames), std::end(builtinSurfaceNames), nameInSpec(spec)) > 0;
}
inline bool isBuiltinFlow(std::string_view spec)
{
    return std::count(std::begin(builtinFlowNames), std::end(builtinFlowNames), nameInSpec(spec)) > 0;
}

}  // namespace aeolic
