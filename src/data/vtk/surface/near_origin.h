#pragma once

#include <vtkDataSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include "base/bounds.h"

namespace aeolic {

/// The data set's points, less `by`, as doubles.
vtkSmartPointer<vtkPoints> pointsLess(vtkDataSet& data, const glm::dvec3& by);

/// A data set that was moved to where VTK can cut it.
struct NearOrigin {
    vtkSmartPointer<vtkDataSet> data;
    glm::dvec3 movedBy{0};  ///< World: added to a point of `data` it gives the point that was meant.
};

/// VTK cuts image data and rectilinear grids into points of single precision, which at 1e7 are a metre apart, and finds
/// the plane through curvilinear grids no better. What is farther from the origin than it is large is moved there;
/// arrays are shared, points are copied. `boundsWorld`: of all of it, where `data` is a piece. What is near stays.
NearOrigin nearOrigin(vtkDataSet& data, const Bounds& boundsWorld);

/// Where a surface lies that was cut out of such a data set.
void moveBack(vtkPolyData& surface, const NearOrigin& from);

}  // namespace aeolic
