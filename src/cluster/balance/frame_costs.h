#pragma once

#include <cstdint>

#include "aeolic/scene_description.h"
#include "cluster/balance/network_model.h"
#include "cluster/balance/row_coverage.h"

namespace aeolic {

/// What drawing costs one core, in nanoseconds: measured (`aeolic-bench scaling`, "costs" of its JSON; the built-in
/// teapot from 800x800 to 3840x2160), on a machine of 2024. Only their ratios matter, and only for who does what: a
/// picture never depends on them.
struct FrameCosts {
    double projectNs = 28;        ///< A covered pixel: visibility and resolve.
    double convolveNs = 64;       ///< … LIC, all levels; of a guard pixel too where levels are computed again.
    double projectAreaNs = 0.15;  ///< Any pixel of the rows projected, background too.
    double convolveAreaNs = 0.2;  ///< Any pixel of the stripe and its guard.
    double shadeNs = 0.32;        ///< Any pixel of the stripe.
    double runNs = 0;             ///< A run of covered pixels in a row, beside them: its ends leave vectors half empty.
    double copyNs = 2;            ///< Packing and unpacking a guard pixel, all its levels.
    double receiveNs = 3;         ///< The same with its way in between.

    double pixelNs() const { return projectNs + convolveNs; }
};

FrameCosts frameCosts(const LicOptions& lic, const NetworkModel& network = {});

/// What a guard pixel takes on the network where it is received, all its levels.
int guardPixelBytes(const LicOptions& lic);

enum class GuardSource {
    project,  ///< Guard rows are projected again, as in the paper, and levels of jumps computed there again.
    receive   ///< They come from the ranks that own them.
};

/// The cost model's choice (docs/cluster.md): drawing `guardRows` on each side of a stripe of `stripeRows` again, or
/// receiving them in `messages` messages. `width` pixels a row.
GuardSource cheaperGuard(const FrameCosts& costs, const LicOptions& lic, int width, int guardRows, int messages,
                         const NetworkModel& network = {});

/// The cost model's choice of who counts what `triangles` cover: each rank all of them, or each a part, telling the
/// others in `bytes` which pixels those are.
bool cheaperShared(std::int64_t triangles, std::int64_t bytes, int ranks, const NetworkModel& network = {});

/// What estimates leave of a guard that is received, by bytes: measured, that teapot on eight ranks.
inline constexpr double kEstimatedPart = 0.36;

/// In units of one covered pixel, for the hybrid balancer: what keeps a rank busy, and so without the network.
/// `receivedPart`: of a guard of `guardRows` that is received, what really is.
StripeCosts stripeCosts(const FrameCosts& costs, const LicOptions& lic, GuardSource source, int width, int guardRows,
                        double receivedPart = 1);

}  // namespace aeolic
