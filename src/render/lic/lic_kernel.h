#pragma once

#include <vector>

#include "aeolic/scene_description.h"
#include "base/image.h"

namespace aeolic {

/// What the LIC stage makes of each pixel: the mean noise along its streamline times the contrast gain. About unit
/// variance, zero mean; 0 where there is no flow.
using LicImage = Image<float>;

/// What i steps make of two numbers that a trace carries: (a, b) becomes (aa a + ab b, ba a + bb b).
struct Turn {
    float aa = 1, ab = 0, ba = 0, bb = 1;
};

/// The convolution kernel, as methods see it, sampled at whole steps from -steps to steps; upstream is negative.
///   box   1
///   hann  (1 + cos(pi i / (steps + 1/2) - phase)) / 2: a bump one kernel long that travels along the streamline as the
///         phase grows and re-enters behind (Cabral & Leedom 1993; Forssell & Cohen 1995)
///   ramp  (1 - i / steps) / 2: what a grain adds to a pixel grows with its distance upstream. So the grain is drawn
///         out into a streak that is brightest at its head, downstream, and ends there (Wegenkittl, Gröller &
///         Purgathofer 1997).
///   wave  cos(pi i / (steps + 1/2) - phase) / 2: hann without its mean. From grains with a phase each two of them make
///         what flows of oriented streaks (phase_mix.h).
///
/// A weight is the mean and half of one number of a pair that turns as a trace goes on: cos and sin of an angle, or 1
/// and the share of the kernel walked, which is the first moment. Jumps keep two sums for such a pair beside the plain
/// one. So a jump that starts i steps on is joined by turning its sums, and a kernel of this kind needs no new method.
struct KernelModel {
    enum class Shape { box, hann, ramp, wave };

    Shape shape = Shape::box;
    int steps = 0;
    double phaseRad = 0;
    double meanWeight = 1;
    double concentration = 1;  ///< How much its shape concentrates its weight: f of the contrast (ContrastModel).
    /// The result is half of what these make of the plain sum and of the two weighted ones.
    float ofPlain = 1, ofFirst = 0, ofSecond = 0;

    /// Whether jumps keep the two weighted sums.
    bool weighted() const { return shape != Shape::box; }
    /// The weight of step `i`. Cost: a cosine for hann.
    double weight(int i) const;
};
/// `lic.steps`: the kernel's own, kernelSteps() of those asked for.
KernelModel makeKernelModel(const LicOptions& lic);

/// The kernel's steps in each direction, of those asked for. Oriented streaks are short: a grain's streak ends before
/// many others begin beside it, for these hide its head (decision 0033).
int kernelSteps(const LicOptions& asked);

/// All weights of a kernel, for methods that walk step by step.
struct KernelWeights {
    int steps = 0;
    std::vector<float> forward, backward;  ///< [steps + 1]: weights of steps 0 to steps, downstream and upstream.
};
KernelWeights makeKernelWeights(const KernelModel& kernel);

/// [steps + 1] What 0 to all steps make of the weighted sums, downstream where `sign` is 1 and upstream where it is -1;
/// empty for a box. A sample after i steps adds its noise times (aa, ba).
std::vector<Turn> turnsOf(const KernelModel& kernel, float sign);

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
///
/// A Hann kernel whose phase is not 0 has its weight elsewhere. Where streamlines are shorter than the kernel there is
/// less of it, or next to nothing, and streaks that flow would fade and come back. So the value is multiplied by
/// sqrt(V(0) / V(phase)), where V is the kernel's squared weight between the ends: L_k / (own step * steps) of the way
/// to either end of the kernel. It is 1 where the kernel is whole.
struct ContrastModel {
    float zeroLength;                      ///< a^2
    float perLength;                       ///< (b / f)^2, pixels^-2
    float inverseMeanWeight;               ///< Of the kernel; of oriented streaks, less a little contrast.
    float phaseCosine = 1, phaseSine = 0;  ///< Of a Hann kernel's phase.
    float perStep = 0;                     ///< 1 / steps

    bool phased() const { return phaseCosine != 1; }
};
/// The greatest gain for a phase: beyond, the few weights left show how sums were rounded.
inline constexpr float kMostPhaseGain = 4;

/// The starting pixel's own sample has at least this length: without flow it shows its own noise.
inline constexpr float kShortestOwnPx = 1.0f / 16;

ContrastModel makeContrastModel(const LicOptions& lic);

}  // namespace aeolic
