#pragma once

#include <vector>

#include "aeolic/scene_description.h"
#include "base/image.h"

namespace aeolic {

/// What the LIC stage makes of each pixel: the mean noise along its streamline times the contrast gain. About unit
/// variance, zero mean; 0 where there is no flow.
using LicImage = Image<float>;

/// The convolution kernel, as methods see it: a mean and cosines over its length, sampled at whole steps from -steps to
/// steps. box: 1. hann: (1 + cos(pi i / (steps + 1/2) - phase)) / 2, a bump one kernel long that travels along the
/// streamline as the phase grows and re-enters behind (Cabral & Leedom 1993; Forssell & Cohen 1995). Jumps keep a sum
/// for each cosine beside the plain one, and so a new kernel of few cosines needs no new method.
struct KernelModel {
    int steps = 0;
    double phaseRad = 0;
    std::vector<double> frequencies;  ///< Angles of the cosines per step, radians: a box has none, Hann one.
    double meanWeight = 1;
    double concentration = 1;  ///< How much its shape concentrates its weight: f of the contrast (ContrastModel).

    /// Whether sums have to be weighted: 0 or 1 cosine, which is all that methods have sums for.
    bool waves() const { return !frequencies.empty(); }
    /// The weight of step `i`, which is negative upstream. Cost: a cosine for each frequency.
    double weight(int i) const;
};
KernelModel makeKernelModel(const LicOptions& lic);

/// All weights of a kernel, for methods that walk step by step.
struct KernelWeights {
    int steps = 0;
    std::vector<float> forward, backward;  ///< [steps + 1]: weights of steps 0 to steps, downstream and upstream.
};
KernelWeights makeKernelWeights(const KernelModel& kernel);

/// cos and signed sin of a number of steps times the angle of a cosine.
struct Rotation {
    float cosine = 1, sine = 0;
};
/// [steps + 1] Of the kernel's cosine, steps 0 to all; empty where it has none. `sign`: of the sines.
std::vector<Rotation> rotationsOf(const KernelModel& kernel, float sign);

/// How a trace's samples become its LIC value:
///
///   value = gain(E) * sum(weight_i * w_i * ds_i * noise_i) / (L * mean weight),   L = sum(w_i * ds_i)
///
/// ds_i is the length of step i in the image. So a step that hardly moves there (towards the viewer, near a sink)
/// hardly counts, instead of painting a whole basin with the noise of one pixel. The average is over the length walked.
///
/// w_i is 1 for plain streaks. For even ones it is the least width that the stream tube has had between the pixel and
/// the sample, beside its width at the pixel: w = exp(integral of min(0, div v) ds), v the unit direction of the walk.
/// Where streamlines merge, neighbours share all noise that lies beyond, and it would give them all the same shade.
///
/// The gain brings the mean to unit variance. It comes from kernel, noise and weights alone, not from the image:
/// averaged over E pixels, noise of variance 1 / a keeps 1 / b of it per pixel, and
/// gain(E) = (a^2 + (b E / f)^2)^(1/4) meets both ends, where f is how much the kernel's shape concentrates its weight
/// (KernelModel::concentration). E = (sum w ds)^2 / sum w^2 ds is as many pixels of full weight as vary as much. A
/// direction of length L_k whose weight is W_k at its end has sum w^2 ds = L_k (1 + W_k) / 2, which is exact for
/// constant weights and for those that fall exponentially.
struct ContrastModel {
    float zeroLength;         ///< a^2
    float perLength;          ///< (b / f)^2, pixels^-2
    float inverseMeanWeight;  ///< Of the kernel.
};

/// The starting pixel's own sample has at least this length: without flow it shows its own noise.
inline constexpr float kShortestOwnPx = 1.0f / 16;

ContrastModel makeContrastModel(const LicOptions& lic);

}  // namespace aeolic
