#include "data/vtk/surface/cut.h"

#include <fmt/format.h>
#include <vtk3DLinearGridPlaneCutter.h>
#include <vtkContourFilter.h>
#include <vtkCutter.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "aeolic/error.h"
#include "base/number_near.h"
#include "base/parallel.h"
#include "data/mesh/surface_mesh.h"
#include "data/vtk/messages.h"
#include "data/vtk/surface/isosurface.h"
#include "data/vtk/surface/near_origin.h"
#include "data/vtk/surface/outer_surface.h"
#include "description/scene_surfaces.h"

namespace aeolic {

namespace {

constexpr int coarseCells = 32;
constexpr double marginCells = 1e-3;
constexpr std::uint64_t kTrianglesOfCrossedCell = 2;  // About: one or two in a tetrahedron, up to five in a voxel.

Bounds boundsOf(vtkDataSet& data)
{
    double b[6];
    data.GetBounds(b);
    Bounds bounds;
    bounds.add({b[0], b[2], b[4]});
    bounds.add({b[1], b[3], b[5]});
    return bounds;
}

/// The same box, a hair smaller, with few cells.
vtkSmartPointer<vtkImageData> coarseCopy(vtkImageData& image)
{
    const Bounds bounds = boundsOf(image);
    int dims[3];
    double origin[3], spacing[3];
    image.GetDimensions(dims);
    for (int c = 0; c < 3; ++c) {
        const double margin = marginCells * image.GetSpacing()[c];
        dims[c] = std::min(dims[c], coarseCells + 1);
        origin[c] = bounds.lo[c] + margin;
        spacing[c] = (bounds.hi[c] - bounds.lo[c] - 2 * margin) / (dims[c] - 1);
    }
    auto coarse = vtkSmartPointer<vtkImageData>::New();
    coarse->SetDimensions(dims);
    coarse->SetOrigin(origin);
    coarse->SetSpacing(spacing);
    return coarse;
}

template <class Filter>
vtkSmartPointer<vtkPolyData> run(Filter& filter, const std::string& where)
{
    const VtkMessages messages;
    filter.Update();
    if (messages.failed()) throw InputError(where, "cutting failed (" + messages.firstError() + ")", "sound cells");
    return vtkPolyData::SafeDownCast(filter.GetOutputDataObject(0));
}

/// Signed distances of the box's corners from the plane: least and greatest.
std::array<double, 2> distanceRange(const Bounds& box, const SurfaceSpec& spec)
{
    const glm::dvec3 origin = vectorOf(spec.origin), normal = vectorOf(spec.normal);
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                           corner & 4 ? box.hi.z : box.lo.z};
        const double distance = glm::dot(p - origin, normal);
        range = {std::min(range[0], distance), std::max(range[1], distance)};
    }
    return range;
}

/// All of it lies in a plane across an axis.
bool isFlat(const Bounds& bounds)
{
    const glm::dvec3 size = bounds.hi - bounds.lo;
    return !bounds.empty() && std::min({size.x, size.y, size.z}) <= 1e-9 * bounds.diagonal();
}

[[noreturn]] void failSlice(const Bounds& bounds, const SurfaceSpec& spec, const std::string& where)
{
    if (isFlat(bounds))
        throw InputError(where, fmt::format("'{}' of data that are flat themselves", spec.text),
                         "--surface boundary, or --surface image where they are on a uniform grid");
    std::string from, to;
    for (int c = 0; c < 3; ++c) {
        const double size = bounds.hi[c] - bounds.lo[c];
        from += (c > 0 ? "," : "") + numberNear(bounds.lo[c], size, 6);
        to += (c > 0 ? "," : "") + numberNear(bounds.hi[c], size, 6);
    }
    throw InputError(where, fmt::format("'{}' misses the data", spec.text),
                     fmt::format("a plane through the box from {} to {}", from, to));
}

/// `all`: of the whole data set.
vtkSmartPointer<vtkPolyData> slice(vtkDataSet& data, const SurfaceSpec& spec, const std::string& where,
                                   const Bounds& all)
{
    vtkSmartPointer<vtkDataSet> source = &data;
    Bounds inner = all;
    if (auto* image = vtkImageData::SafeDownCast(&data)) {
        source = coarseCopy(*image);
        inner = boundsOf(*source);
    }
    // A plane on the very face of the box belongs to it: moved inwards by a hair, so that it cuts cells.
    const auto [innerBelow, innerAbove] = distanceRange(inner, spec);
    const double hair = 1e-6 * (innerAbove - innerBelow);
    const double shift = std::clamp(0.0, innerBelow + hair, innerAbove - hair);
    const bool linear = vtk3DLinearGridPlaneCutter::CanFullyProcessDataObject(source);
    const NearOrigin near = linear ? NearOrigin{source} : nearOrigin(*source, all);
    const glm::dvec3 normal = vectorOf(spec.normal);
    const glm::dvec3 origin = vectorOf(spec.origin) - near.movedBy + shift * normal;

    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.x, origin.y, origin.z);
    plane->SetNormal(normal.x, normal.y, normal.z);
    if (linear) {
        // vtkCutter would use this too, but with threads. They put the triangles into another order every time, so
        // ranks and moments would differ.
        vtkNew<vtk3DLinearGridPlaneCutter> cutter;
        cutter->SetInputData(source);
        cutter->SetPlane(plane);
        cutter->MergePointsOff();
        cutter->SequentialProcessingOn();
        return run(*cutter, where);
    }
    vtkNew<vtkCutter> cutter;
    cutter->SetInputData(near.data);
    cutter->SetCutFunction(plane);
    cutter->GenerateCutScalarsOff();
    auto surface = run(*cutter, where);
    moveBack(*surface, near);
    return surface;
}

/// How many cells have points on both sides of the value.
std::uint64_t cellsCrossed(vtkDataSet& data, vtkDataArray& values, double value)
{
    if (data.GetNumberOfCells() == 0) return 0;
    vtkNew<vtkIdList> first;
    data.GetCellPoints(0, first);  // After the first call any number of threads may ask.
    std::atomic<std::uint64_t> crossed{0};
    parallelRanges(std::size_t(data.GetNumberOfCells()), 1 << 14, [&](std::size_t begin, std::size_t end) {
        vtkNew<vtkIdList> points;
        std::uint64_t mine = 0;
        for (std::size_t cell = begin; cell < end; ++cell) {
            data.GetCellPoints(vtkIdType(cell), points);
            bool below = false, above = false;
            for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i) {
                const double v = values.GetComponent(points->GetId(i), 0);
                above = above || v >= value;
                below = below || v < value;
            }
            mine += below && above;
        }
        crossed += mine;
    });
    return crossed;
}

vtkSmartPointer<vtkPolyData> contour(vtkDataSet& data, const SurfaceSpec& spec, const std::string& array,
                                     const std::string& where, const Bounds& all)
{
    const bool hasPoints = vtkPointSet::SafeDownCast(&data) != nullptr;  // VTK keeps their precision.
    const NearOrigin near = hasPoints ? NearOrigin{&data} : nearOrigin(data, all);
    vtkNew<vtkContourFilter> filter;
    filter->SetInputData(near.data);
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
    filter->SetValue(0, spec.value);
    filter->ComputeNormalsOff();
    filter->ComputeScalarsOff();
    auto surface = run(*filter, where);
    moveBack(*surface, near);
    vtkNew<vtkFloatArray> own;  // VTK leaves out the one array that it knows by heart.
    own->SetName(array.c_str());
    own->SetNumberOfValues(surface->GetNumberOfPoints());
    own->FillValue(float(spec.value));
    surface->GetPointData()->AddArray(own);
    return surface;
}

vtkSmartPointer<vtkPolyData> boundary(vtkDataSet& data, const std::string& where)
{
    vtkSmartPointer<vtkDataSet> source = &data;
    if (auto* image = vtkImageData::SafeDownCast(&data))
        if (image->GetDataDimension() == 3) source = coarseCopy(*image);
    return outerSurface(*source, where);
}

/// The one layer of a plane grid. Each sample is the middle of its pixel, so the surface ends half a cell beyond the
/// last.
vtkSmartPointer<vtkPolyData> plane(vtkDataSet& data, const std::string& where)
{
    auto* image = vtkImageData::SafeDownCast(&data);
    if (!image)
        throw InputError(where, "--surface image of a field that is not on a uniform grid",
                         "a uniform grid of one layer, or --surface boundary");
    if (image->GetDataDimension() != 2) {
        const int* dims = image->GetDimensions();
        throw InputError(where, fmt::format("--surface image of {} x {} x {} samples", dims[0], dims[1], dims[2]),
                         "a single layer, or --surface slice:…");
    }
    auto surface = boundary(data, where);
    const double *bounds = image->GetBounds(), *spacing = image->GetSpacing();
    vtkPoints& points = *surface->GetPoints();
    points.SetDataTypeToDouble();
    for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i) {
        double p[3];
        points.GetPoint(i, p);
        for (int k = 0; k < 3; ++k) {
            if (bounds[2 * k] == bounds[2 * k + 1]) continue;
            if (p[k] - bounds[2 * k] < 0.5 * spacing[k])
                p[k] = bounds[2 * k] - 0.5 * spacing[k];
            else if (bounds[2 * k + 1] - p[k] < 0.5 * spacing[k])
                p[k] = bounds[2 * k + 1] + 0.5 * spacing[k];
        }
        points.SetPoint(i, p);
    }
    return surface;
}

}  // namespace

void CutOutline::add(const CutOutline& other)
{
    boundsWorld.add(other.boundsWorld);
    range = {std::min(range[0], other.range[0]), std::max(range[1], other.range[1])};
    crossed += other.crossed;
}

CutOutline outlineOfCut(vtkDataSet& data, const SurfaceSpec& spec, const std::string& contourArray)
{
    CutOutline outline;
    if (data.GetNumberOfPoints() > 0) outline.boundsWorld = boundsOf(data);
    if (spec.kind != SurfaceSpec::Kind::isosurface) return outline;
    vtkDataArray& values = *data.GetPointData()->GetArray(contourArray.c_str());
    std::array<double, 2> range{};
    values.GetFiniteRange(range.data(), 0);
    if (values.GetNumberOfTuples() > 0 && range[0] <= range[1]) outline.range = range;
    if (outline.range[0] <= spec.value && spec.value <= outline.range[1])
        outline.crossed = cellsCrossed(data, values, spec.value);
    return outline;
}

void requireCut(const CutOutline& all, const SurfaceSpec& spec, const std::string& where, int ranksOnHost)
{
    if (spec.kind == SurfaceSpec::Kind::slice) {
        const double tolerance = 1e-9 * all.boundsWorld.diagonal();
        const auto [below, above] = distanceRange(all.boundsWorld, spec);
        if (below > tolerance || above < -tolerance) failSlice(all.boundsWorld, spec, where);
    }
    if (spec.kind != SurfaceSpec::Kind::isosurface) return;
    requireWithinRange(spec, where, all.range);
    const std::uint64_t triangles = kTrianglesOfCrossedCell * all.crossed;
    requireRoomFor(spec, where, {triangles / 2, triangles}, ranksOnHost);
}

void requirePolygons(std::size_t polygons, const CutOutline& all, const SurfaceSpec& spec, const std::string& where)
{
    if (spec.kind == SurfaceSpec::Kind::isosurface) requireIsosurface(spec, where, all.range, polygons);
    if (spec.kind == SurfaceSpec::Kind::slice && polygons == 0) failSlice(all.boundsWorld, spec, where);
}

vtkSmartPointer<vtkPolyData> cutSurface(vtkDataSet& data, const SurfaceSpec& spec, const std::string& contourArray,
                                        const std::string& where, const CutOutline& all)
{
    switch (spec.kind) {
        case SurfaceSpec::Kind::slice:
            return slice(data, spec, where, all.boundsWorld);
        case SurfaceSpec::Kind::isosurface:
            return contour(data, spec, contourArray, where, all.boundsWorld);
        case SurfaceSpec::Kind::image:
            return plane(data, where);
        default:
            return boundary(data, where);
    }
}

}  // namespace aeolic
