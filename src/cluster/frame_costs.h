#pragma once

#include "aeolic/scene_description.h"
#include "cluster/network_model.h"
#include "cluster/row_coverage.h"

namespace aeolic {

/// What a covered pixel costs one core, in nanoseconds: measured (`aeolic bench stages --threads 1`), on a machine of
/// 2024. Only their ratios matter, and only for who does what: a picture never depends on them.
struct FrameCosts {
    double projectNs = 18;   ///< Visibility and resolve.
    double convolveNs = 60;  ///< LIC, all levels; of a guard pixel too where levels are computed again.
    double shadeNs = 4;      ///< Any pixel of the stripe, background too.
    double receiveNs = 2;    ///< Packing, sending and unpacking a guard pixel, all its levels.

    double pixelNs() const { return projectNs + convolveNs + shadeNs; }
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

/// In units of one covered pixel, for the hybrid balancer.
StripeCosts stripeCosts(const FrameCosts& costs, const LicOptions& lic, GuardSource source, int width, int guardRows);

}  // namespace aeolic
