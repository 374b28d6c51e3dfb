#pragma once

#if __cplusplus >= 202002L
#include <stop_token>
#endif
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Flow in a plane: one vector a pixel, rows of `width` one after the other.
struct PlaneFlow {
    int width = 0, height = 0;  ///< [1, 32768]
    const float* u = nullptr;   ///< [height][width] along a row, towards higher columns.
    const float* v = nullptr;   ///< [height][width] across rows, towards higher rows.
    /// [height][width] the noise, or null: white noise from `lic.seed`, or grains with lic.style oriented. The span of
    /// its finite values is taken for black to white; values that are not finite count as its middle.
    const float* texture = nullptr;
    bool periodic = false;  ///< Streamlines go out at one end and come in at the other; false: they end there.
    /// (u, v) and (-u, -v) are the same, as of polarization: streamlines take the one that is nearer to where they go,
    /// so signs may jump from pixel to pixel. By the direct method alone, in the dense style.
    bool axial = false;
};

/// The line integral convolution of a plane, by the kernels that draw surfaces: [height][width] values of zero mean and
/// about unit variance. Where u or v is not finite, as on land, nothing flows: streamlines end there, and the value is
/// NaN. `lic.step` is in pixels. `lic.noiseScale` is of no effect. With lic.method none all values are 0. The same
/// bytes from any number of threads. Throws aeolic::InputError for options and sizes out of range.
/// Cost: as for a picture of that size. `periodic` adds a border of steps * step pixels on all sides, however small
/// the plane is: memory grows with the square of that, at 100 bytes a pixel, and so does the time of the hierarchical
/// method. InputError says so where there is no memory for it. Large planes go through in parts, so that the memory
/// beside the arrays grows with the root of their height.
std::vector<float> licOfPlane(const PlaneFlow& flow, const LicOptions& lic);
/// Writes what the function above returns into memory of the caller: [height][width]. Where it throws, it has written
/// nothing, or a part.
void licOfPlane(const PlaneFlow& flow, const LicOptions& lic, float* values);
#if __cplusplus >= 202002L
/// The line integral convolution in memory of the caller, which ends where it is asked to: it returns soon after `stop`
/// is requested, and has written nothing then, or a part.
void licOfPlane(const PlaneFlow& flow, const LicOptions& lic, float* values, const std::stop_token& stop);
#endif

}  // namespace aeolic
