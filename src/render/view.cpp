#include "render/view.h"

#include <algorithm>
#include <cmath>

#include "render/gbuffer.h"
#include "render/lic/lic_kernel.h"
#include "render/lic/phase_mix.h"
#include "render/shading_model.h"
#include "render/units.h"

namespace aeolic {

View makeView(const Camera& camera, const Scene& scene, const LicOptions& lic)
{
    View view;
    view.camera = camera;
    view.unitWorld = lengthUnit(scene);
    view.eyeLocal = glm::vec3((camera.positionWorld - scene.surface.originWorld) / view.unitWorld);
    view.right = glm::vec3(camera.right);
    view.up = glm::vec3(camera.up);
    view.forward = glm::vec3(camera.forward);
    view.softLight =
        shading::kSoftRight * view.right + shading::kSoftUp * view.up + shading::kSoftForward * view.forward;
    view.focalPx = float(camera.focalPx);
    view.centerX = 0.5f * float(camera.width);
    view.centerY = 0.5f * float(camera.height);
    view.nearDepth = camera.nearDepth / view.unitWorld;
    view.nearInvDepth = float(1.0 / view.nearDepth);
    view.farInvDepth = float(view.unitWorld / camera.farDepth);

    view.frontFacesOnly = scene.frontFacesOnly;
    view.normalize = lic.normalize && lic.magnitude != Magnitude::length;
    const double vectorUnit = aeolic::vectorUnit(scene), maxVector = scene.maxVector / vectorUnit;
    view.fadePerVector =
        lic.magnitude == Magnitude::contrast && maxVector > 0 ? float(vectorUnit / scene.fullStreaks()) : 0.0f;
    view.vectorUnit = float(vectorUnit);
    view.vectorFactor = float(1 / vectorUnit);
    view.maskBelow = float(lic.maskBelow / vectorUnit);
    // A step of length h at depth z covers at most h * focalPx / z * sec(angle off the axis) pixels.
    const double halfX = 0.5 * camera.width / camera.focalPx, halfY = 0.5 * camera.height / camera.focalPx;
    const double sec = std::sqrt(1 + halfX * halfX + halfY * halfY);
    const double magnification = camera.focalPx / camera.nearDepth * sec;
    const double askedWorld = lic.step * camera.pixelSizeAtBody();
    const double parts = std::ceil(askedWorld * magnification / double(kLongestStepPx));
    view.stepParts = int(std::clamp(parts, 1.0, double(kMostStepParts)));
    const double stepWorld = askedWorld / view.stepParts;
    view.stepLocal = float(stepWorld / view.unitWorld);
    view.vectorScale = maxVector > 0 ? float(stepWorld / view.unitWorld / maxVector) : 0.0f;
    // The direction of a vector shorter than a millionth of the largest is the data's rounding noise.
    view.tinyVector = float(maxVector * 1e-6);

    view.maxStepPx = float(std::min(stepWorld * magnification, double(kLongestStepPx)));
    const double powerOfTwo = std::exp2(std::ceil(std::log2(std::max(double(view.maxStepPx), 1e-3))));
    view.flowUnitPx = float(powerOfTwo / (flow_texel::kDisplacementMax + 1));

    view.noiseSeed = lic.seed;
    view.noiseStyle = lic.style;
    view.noise = makeNoiseLookup(scene.boundsWorld.diagonal() / view.unitWorld, lic.noiseScale, lic.style);
    if (phase_mix::isComets(lic)) view.noise.grains = phase_mix::runsOf(lic).front().grains;
    return view;
}

LicOptions inShortSteps(LicOptions lic, const View& view)
{
    lic.steps = kernelSteps(lic) * view.stepParts;
    lic.step /= view.stepParts;
    return lic;
}

View coarseView(const View& view, int factor)
{
    View coarse = view;
    coarse.camera.width = (view.camera.width + factor - 1) / factor;
    coarse.camera.height = (view.camera.height + factor - 1) / factor;
    coarse.camera.focalPx /= factor;
    coarse.focalPx /= float(factor);
    coarse.centerX /= float(factor);
    coarse.centerY /= float(factor);
    return coarse;
}

}  // namespace aeolic
