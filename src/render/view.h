#pragma once

#include <glm/glm.hpp>

#include "data/scene.h"
#include "description/camera.h"
#include "render/lic/noise.h"

namespace aeolic {

/// A camera's constants in the form kernels use: P-space is local (relative to the surface's originWorld), in floats
/// and in units of `unitWorld`. `camera` itself stays in the world's. Everything follows from camera, scene and options
/// alone, never from the rows a rank draws.
struct View {
    Camera camera;
    double unitWorld = 1;  ///< World units in a kernel's unit of length: a power of two (units.h).
    double nearDepth = 0;  ///< The camera's, in kernels' units.
    glm::vec3 eyeLocal{0}, right{0}, up{0}, forward{0};
    glm::vec3 softLight{0};                       ///< Where it comes from (shading_model.h); unit length.
    float focalPx = 1, centerX = 0, centerY = 0;  ///< Pixels; the centre of the image.
    float nearInvDepth = 0, farInvDepth = 0;      ///< 1 / nearDepth > 1 / farDepth.

    bool frontFacesOnly = false;

    /// Vectors count in a unit of kernels, too: what one of the data is in that unit, and the other way round.
    float vectorFactor = 1, vectorUnit = 1;
    float maskBelow = 0;  ///< No streaks show where the vector is shorter, in kernels' unit.
    bool normalize = true;
    /// The noise is multiplied by the root of this times the vector's length along the surface, where that is below 1;
    /// 0: nowhere.
    float fadePerVector = 0;
    int stepParts = 1;      ///< A step asked for is walked in so many: inShortSteps(). Below, "step" is such a part.
    float stepLocal = 0;    ///< P-space length of a step (normalized), or of a step at the largest magnitude.
    float vectorScale = 0;  ///< Displacement per unit vector where not normalized: stepLocal / the longest.
    float tinyVector = 0;   ///< Vectors shorter than this count as zero.
    float maxStepPx = 0;    ///< No step is longer than this in the image: the paper's v_max * dt (section 5.2).
    float flowUnitPx = 1;   ///< See GBuffer.

    NoiseLookup noise;
    std::uint32_t noiseSeed = 1;
    Style noiseStyle = Style::dense;
};

/// The image shows no step longer than this: each is a sample of the noise, and streaks of samples farther apart look
/// dotted.
inline constexpr float kLongestStepPx = 1.75f;
/// Steps are split into as many parts as that takes, but into no more than this. On surfaces that are nearer still,
/// steps get shorter, and the guard rows stay few.
inline constexpr int kMostStepParts = 5;

View makeView(const Camera& camera, const Scene& scene, const LicOptions& lic);

/// The options with which the LIC stage walks in `view`, which was made for `lic`: equally far, in steps that are short
/// enough.
LicOptions inShortSteps(LicOptions lic, const View& view);

/// `view` at 1 / factor of the resolution, sizes rounded up: pixel (x, y) is centred on the block of pixels that begins
/// at (factor x, factor y).
View coarseView(const View& view, int factor);

}  // namespace aeolic
