#pragma once

#include <cstdint>

#include "aeolic/scene_description.h"
#include "cluster/balance/network_model.h"
#include "cluster/balance/row_coverage.h"

namespace aeolic {

/// What drawing costs one core, in nanoseconds. Measured with `aeolic-bench scaling` ("costs" in its JSON) on a machine
/// of 2024, with the built-in teapot from 800x800 to 3840x2160. Only the ratios matter, and only to share the work: a
/// picture never depends on them.
struct FrameCosts {
    double projectNs = 28;        ///< A covered pixel: visibility and resolve.
    double convolveNs = 64;       ///< A covered pixel: LIC, all levels. A guard pixel too where levels are recomputed.
    double projectAreaNs = 0.15;  ///< Any pixel of the rows projected, background too.
    double convolveAreaNs = 0.2;  ///< Any pixel of the stripe and its guard.
    double shadeNs = 0.32;        ///< Any pixel of the stripe.
    double runNs = 0;             ///< A run of covered pixels in a row, beside its pixels: SIMD vectors are half empty
                                  ///< at its ends.
    double copyNs = 2;            ///< Packing and unpacking a guard pixel, all its levels.
    double receiveNs = 3;         ///< Packing, sending and unpacking a guard pixel, all its levels.

    double pixelNs() const { return projectNs + convolveNs; }
};

FrameCosts frameCosts(const LicOptions& lic, const NetworkModel& network = {});

/// How many bytes of a guard pixel travel where it is received, all its levels.
int guardPixelBytes(const LicOptions& lic);

enum class GuardSource {
    project,  ///< Guard rows are projected again, as in the paper, and levels of jumps computed there again.
    receive   ///< Guard rows come from the ranks that own them.
};

/// The cost model's choice (docs/cluster.md): drawing `guardRows` on each side of a stripe again, or receiving them in
/// `messages` messages. A row has `width` pixels.
GuardSource cheaperGuard(const FrameCosts& costs, const LicOptions& lic, int width, int guardRows, int messages,
                         const NetworkModel& network = {});

/// The cost model's choice of how ranks count the pixels that `triangles` cover. False: each rank counts all triangles.
/// True: each counts a part, and tells the others in `bytes` which pixels that part covers.
bool cheaperShared(std::int64_t triangles, std::int64_t bytes, int ranks, const NetworkModel& network = {});

/// The part of a received guard, by bytes, that is left when rows are estimated. Measured: that teapot on eight ranks.
inline constexpr double kEstimatedPart = 0.36;

/// What keeps a rank busy, in units of one covered pixel, for the hybrid balancer. The network is left out.
/// `receivedPart`: the part of a guard of `guardRows` that really is received.
StripeCosts stripeCosts(const FrameCosts& costs, const LicOptions& lic, GuardSource source, int width, int guardRows,
                        double receivedPart = 1);

}  // namespace aeolic
