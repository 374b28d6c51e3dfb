#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace aeolic {

/// Frames per second that bachthaler2006parallel, section 7, measured on eight nodes, each a GeForce 6800 Ultra.
namespace paper {

struct Row {
    std::string_view balance;   ///< Ours of the same name.
    std::string_view name;      ///< The paper's.
    std::array<double, 8> fps;  ///< On 1 to 8 nodes.
};

/// Table 1: the teapot turning about its axis, a 128^3 field on each node, 800x800.
inline constexpr std::array<Row, 3> kTable1{{
    {"static", "static stripes", {2.23, 3.86, 2.82, 4.01, 4.12, 5.07, 5.06, 6.29}},
    {"timing", "dynamic time-based", {2.23, 4.00, 5.62, 6.67, 7.91, 9.10, 10.12, 10.89}},
    {"pixels", "dynamic pixel-based", {2.23, 3.83, 5.21, 6.29, 7.25, 8.14, 8.95, 9.67}},
}};

/// The field in bricks on eight nodes; figure 6 does not say how it was balanced.
struct Bricked {
    double fixed, dynamic;
};
inline constexpr Bricked kSmallField{3.11, 3.90}, kLargeField{3.08, 3.79};
inline constexpr double kMesh = 2.22;

/// Null beyond eight nodes, and for balancers that the paper has not.
inline std::optional<double> table1(std::string_view balance, int nodes)
{
    for (const Row& row : kTable1)
        if (row.balance == balance && nodes >= 1 && nodes <= int(row.fps.size()))
            return row.fps[std::size_t(nodes) - 1];
    return std::nullopt;
}

}  // namespace paper

}  // namespace aeolic
