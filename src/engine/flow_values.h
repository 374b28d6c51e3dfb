#pragma once

#include "aeolic/topology.h"
#include "data/scene.h"
#include "data/topology/point_flow.h"
#include "data/topology/surface_place.h"

namespace aeolic {

/// What a scene has at places of its surface, by the flow at points.
class FlowValues {
public:
    /// Both must outlive this.
    FlowValues(const Scene& scene, const PointFlow& flow) : scene_(scene), flow_(flow) {}

    SurfaceValues at(const SurfacePlace& place) const;

private:
    double scalarOf(const SurfacePlace& place, const glm::dvec3& position, const glm::dvec3& vector) const;

    const Scene& scene_;
    const PointFlow& flow_;
};

}  // namespace aeolic
