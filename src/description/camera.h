#pragma once

#include <glm/glm.hpp>

#include "aeolic/scene_description.h"
#include "base/bounds.h"

namespace aeolic {

/// A resolved perspective view. Pixel (x, y) looks along forward + xs * right - ys * up with
/// xs = (x + 0.5 - width / 2) / focalPx, ys = (y + 0.5 - height / 2) / focalPx; x to the right, y down.
struct Camera {
    glm::dvec3 positionWorld{0};
    glm::dvec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};  ///< Orthonormal, world axes.
    int width = 0, height = 0;                                 ///< Pixels of the whole image.
    double fovDeg = 30;                                        ///< Vertical; a zoom may have narrowed it.
    double focalPx = 1;                                        ///< Distance of the image plane in pixels.
    double focalDistance = 1;                                  ///< World units from the eye to the focal point.
    double bodyDepth = 1;                                      ///< Eye depth that the body counts as seen at.
    double nearDepth = 0, farDepth = 1;                        ///< Eye depths, 0 < near < far.

    /// World size of a pixel of an unforeshortened surface at the body's depth: the unit of `--step`.
    double pixelSizeAtBody() const { return bodyDepth / focalPx; }

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Where a moving surface is at one moment: its bounds then, and its radius about the centre of the bounds it is fitted
/// by.
struct SurfaceReach {
    Bounds boundsWorld;
    double radius = 0;
};

/// The camera `options` ask for. Relative views fit the sphere of `radius` about the bounds' centre, so a turn never
/// changes the distance; azimuth 0 looks along +y with z up and x to the right. A zoom comes closer as far as half a
/// radius before that sphere, then narrows the field of view. The depths hold the surface where it is `now`; a surface
/// that does not move is within the bounds.
/// Throws InputError where position, focal point and up do not make a view.
Camera makeCamera(const CameraOptions& options, const Bounds& boundsWorld, double radius, int width, int height,
                  const SurfaceReach& now = {});

/// `options` themselves, unless they are the default view: then the view straight at a plane that is flat in one of the
/// axes, which fills a picture of this shape. Looked at from +x, -y or +z; up is z, or y where z is the flat one. With
/// as many pixels as samples, each pixel's middle is a sample.
CameraOptions straightAt(const CameraOptions& options, const Bounds& planeWorld, int width, int height);

/// `options` themselves, unless they are the default view and that shows a plane of this normal (unit length) from its
/// edge, or nearly so: then the view straight at the plane.
CameraOptions offEdge(const CameraOptions& options, const glm::dvec3& planeNormal);

/// How many degrees the camera turns over the whole animation of a scene.
double orbitDegOf(const SceneDescription& scene);

/// `options` turned by `degrees` about the focal point, counterclockwise seen from above (from the end of `up`).
CameraOptions orbited(const CameraOptions& options, double degrees, const Bounds& boundsWorld);

}  // namespace aeolic
