#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "cluster/balance/network_model.h"

namespace aeolic {

/// The Infiniband of bachthaler2006parallel, section 7: "data transfer rates of up to 800 MB per second". The paper
/// says nothing of its latency; 5 us was usual at its time.
inline constexpr NetworkModel kPaperNetwork{800e6, 5};

/// Frames per second that bachthaler2006parallel, section 7, measured on eight nodes, each a GeForce 6800 Ultra.
namespace paper {

struct Row {
    std::string_view balance;   ///< Our balancer of the same kind.
    std::array<double, 8> fps;  ///< On 1 to 8 nodes.
};

/// Table 1: the teapot turning about its axis, a 128^3 field on each node, 800x800. Static stripes, and dynamic ones
/// balanced by time and by pixels.
inline constexpr std::array<Row, 3> kTable1{{
    {"static", {2.23, 3.86, 2.82, 4.01, 4.12, 5.07, 5.06, 6.29}},
    {"timing", {2.23, 4.00, 5.62, 6.67, 7.91, 9.10, 10.12, 10.89}},
    {"pixels", {2.23, 3.83, 5.21, 6.29, 7.25, 8.14, 8.95, 9.67}},
}};

/// The field in bricks on eight nodes, with static stripes and with dynamic ones.
struct Bricked {
    double fixed, dynamic;
};
inline constexpr Bricked kSmallField{3.11, 3.90}, kLargeField{3.08, 3.79};
/// Figure 6, a finer surface in the large field. The paper does not say how it was balanced.
inline constexpr double kMesh = 2.22;

/// Null beyond eight nodes, and for balancers that the paper does not have.
inline std::optional<double> table1(std::string_view balance, int nodes)
{
    for (const Row& row : kTable1)
        if (row.balance == balance && nodes >= 1 && nodes <= int(row.fps.size()))
            return row.fps[std::size_t(nodes) - 1];
    return std::nullopt;
}

}  // namespace paper

}  // namespace aeolic
