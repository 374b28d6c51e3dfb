#pragma once

/// A small OpenFOAM case for the tests; compiled into the tests only.

#include <string>
#include <vector>

namespace aeolic::test {

/// A channel of 8 x 4 x 3 cells along x with a bump in its floor. Patches: inlet, outlet, floor and roof (walls of the
/// group solid), sides (slip). Fields at every time t: U, p, wallShearStress, which is (1 + x, 0, z) (1 + t) on the
/// floor's faces at (x, y, z), and zero but on walls.
struct SampleCase {
    bool binary = false, gzip = false, longLabels = false, bigEndian = false;
    int processors = 0;  ///< 0: one mesh. Otherwise slabs along x, each in a folder of its own.
    int collated = 0;    ///< So many processors have a folder in common.
    std::vector<std::string> times{"0", "1"};
    std::string region = {};
};

constexpr int kSampleFloorFaces = 8 * 3;

void writeSampleCase(const std::string& folder, const SampleCase& sample = {});

}  // namespace aeolic::test
