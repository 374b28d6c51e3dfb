#include "data/vtk/grid/uniform_grid.h"

#include <fmt/format.h>
#include <vtkCommand.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProbeFilter.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "base/half.h"
#include "base/memory.h"
#include "data/vtk/arrays.h"
#include "data/vtk/messages.h"

namespace aeolic {

namespace {

constexpr double mostSamplesByDefault = 512.0 * 512.0 * 512.0;

void requireAxisAligned(vtkImageData& image, const std::string& where)
{
    if (!image.GetDirectionMatrix()->IsIdentity())
        throw InputError(where, "its axes are turned (the Direction attribute is not the identity)",
                         "samples along x, y and z, or a structured grid");
    const auto refuse = [&](const char* what, const double* found, const char* expected) {
        throw InputError(where, fmt::format("its {} is {:g},{:g},{:g}", what, found[0], found[1], found[2]), expected);
    };
    for (int c = 0; c < 3; ++c) {
        if (image.GetDimensions()[c] < 2) continue;
        const double origin = image.GetOrigin()[c], spacing = image.GetSpacing()[c];
        if (!std::isfinite(origin)) refuse("origin", image.GetOrigin(), "finite numbers");
        if (!(spacing > 0 && std::isfinite(spacing))) refuse("spacing", image.GetSpacing(), "positive numbers");
    }
}

/// Distance of the coordinates if they are even to 1e-5 of it (what text files and floats leave of it), else nothing.
std::optional<double> evenSpacing(vtkDataArray& coordinates)
{
    const vtkIdType count = coordinates.GetNumberOfTuples();
    if (count < 2) return std::nullopt;
    const double first = coordinates.GetTuple1(0),
                 step = (coordinates.GetTuple1(count - 1) - first) / double(count - 1);
    if (!(step > 0)) return std::nullopt;
    for (vtkIdType i = 1; i < count; ++i)
        if (!(std::abs(coordinates.GetTuple1(i) - (first + double(i) * step)) <= 1e-5 * step)) return std::nullopt;
    return step;
}

vtkSmartPointer<vtkImageData> evenGrid(vtkRectilinearGrid& grid)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    vtkDataArray* axes[3] = {grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates()};
    double origin[3], spacing[3];
    for (int c = 0; c < 3; ++c) {
        const auto step = evenSpacing(*axes[c]);
        if (!step) return nullptr;
        origin[c] = axes[c]->GetTuple1(0);
        spacing[c] = *step;
    }
    image->SetDimensions(grid.GetDimensions());
    image->SetOrigin(origin);
    image->SetSpacing(spacing);
    image->GetPointData()->ShallowCopy(grid.GetPointData());
    return image;
}

/// Cells of about `step` that span the size.
glm::dvec3 cellsFor(const double size[3], double step)
{
    glm::dvec3 cells;
    for (int c = 0; c < 3; ++c) cells[c] = std::max(1.0, std::ceil(size[c] / step - 1e-9));
    return cells;
}

double samplesOf(const glm::dvec3& cells)
{
    return (cells.x + 1) * (cells.y + 1) * (cells.z + 1);
}

/// Isotropic spacing for a number of samples about the number of points, and at most twice that in a box far from a
/// cube.
double defaultSpacing(const double size[3], vtkIdType points)
{
    const double samples = std::min(double(std::max<vtkIdType>(points, 1000)), mostSamplesByDefault);
    double step = std::cbrt(size[0] * size[1] * size[2] / samples);
    while (samplesOf(cellsFor(size, step)) > 2 * samples) step *= 1.05;
    return step;
}

struct ProbeProgress {
    vtkAlgorithm* algorithm;
    ProgressReport report;

    void tell() { report("resampling the field", algorithm->GetProgress()); }
};

}  // namespace

vtkSmartPointer<vtkImageData> asUniform(vtkDataSet& data, const std::string& where)
{
    vtkSmartPointer<vtkImageData> image = vtkImageData::SafeDownCast(&data);
    if (image) requireAxisAligned(*image, where);
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data)) image = evenGrid(*grid);
    if (!image) return nullptr;
    const int* dims = image->GetDimensions();
    return dims[0] >= 2 && dims[1] >= 2 && dims[2] >= 2 ? image : nullptr;
}

vtkSmartPointer<vtkImageData> resampleToUniform(vtkDataSet& data, std::optional<double> spacing,
                                                const std::string& where, const ProgressReport& progress)
{
    double bounds[6], size[3];
    data.GetBounds(bounds);
    for (int c = 0; c < 3; ++c) size[c] = bounds[2 * c + 1] - bounds[2 * c];
    const bool finite = std::isfinite(size[0]) && std::isfinite(size[1]) && std::isfinite(size[2]);
    if (!finite) throw InputError(where, "a point of the grid is not finite", "finite coordinates");
    if (!(size[0] > 0 && size[1] > 0 && size[2] > 0))
        throw InputError(where, fmt::format("the data is flat: {:g} x {:g} x {:g}", size[0], size[1], size[2]),
                         "a 3D field to sample, or --surface boundary to draw the flat data itself");
    const double step = spacing ? *spacing : defaultSpacing(size, data.GetNumberOfPoints());
    int dims[3];
    double gridSpacing[3];
    const glm::dvec3 cells = cellsFor(size, step);
    for (int c = 0; c < 3; ++c) {
        dims[c] = int(std::min(cells[c] + 1, 2e9));
        gridSpacing[c] = size[c] / cells[c];
    }
    double bytes = 4;  // The probe's own flags.
    for (const ArrayInfo& array : arraysOf(data))
        if (array.onPoints) bytes += array.components * std::max(1, vtkDataArray::GetDataTypeSize(array.vtkType));
    requireMemory(where,
                  fmt::format("resampling to {} x {} x {} samples, {:.4g} apart", dims[0], dims[1], dims[2], step),
                  static_cast<std::uint64_t>(std::min(samplesOf(cells) * bytes, 1e19)));

    auto grid = vtkSmartPointer<vtkImageData>::New();
    grid->SetDimensions(dims);
    grid->SetOrigin(bounds[0], bounds[2], bounds[4]);
    grid->SetSpacing(gridSpacing);
    vtkNew<vtkProbeFilter> probe;
    probe->SetInputData(grid);
    probe->SetSourceData(&data);
    ProbeProgress target{probe, progress};
    probe->AddObserver(vtkCommand::ProgressEvent, &target, &ProbeProgress::tell);
    const VtkMessages messages;
    probe->Update();
    if (messages.failed()) throw InputError(where, "resampling failed (" + messages.firstError() + ")", "sound cells");
    vtkSmartPointer<vtkImageData> result = vtkImageData::SafeDownCast(probe->GetOutput());
    return result;
}

vtkSmartPointer<vtkImageData> wholeStructure(vtkImageData& image, const ImagePiece& piece)
{
    auto whole = vtkSmartPointer<vtkImageData>::New();
    std::array<int, 6> extent = piece.wholeExtent;
    whole->SetExtent(extent.data());
    whole->SetOrigin(image.GetOrigin());
    whole->SetSpacing(image.GetSpacing());
    return whole;
}

GridField gridStructure(vtkImageData& image, const std::optional<ImagePiece>& piece)
{
    GridField field;
    int extent[6];
    image.GetExtent(extent);
    if (piece) {
        std::copy(piece->wholeExtent.begin(), piece->wholeExtent.end(), extent);
        field.brick = piece->brick;
    }
    for (int c = 0; c < 3; ++c) {
        field.dims[std::size_t(c)] = extent[2 * c + 1] - extent[2 * c] + 1;
        field.spacingWorld[c] = image.GetSpacing()[c];
        field.originWorld[c] = image.GetOrigin()[c] + extent[2 * c] * image.GetSpacing()[c];
    }
    return field;
}

void setSamples(GridField& field, const vtkSmartPointer<vtkFloatArray>& samples)
{
    field.components = samples->GetNumberOfComponents();
    const float* values = samples->GetPointer(0);
    field.samples = std::shared_ptr<const void>(values, [samples](const void*) {});
}

void makeHalf(GridField& field, const vtkSmartPointer<vtkFloatArray>& samples)
{
    const std::size_t count = field.sampleCount() * std::size_t(field.components);
    convertToHalvesInPlace(samples->GetPointer(0), count);
    // One float more than needed: a 32-bit gather of the last half may read two bytes past it.
    samples->SetNumberOfComponents(1);
    samples->Resize(vtkIdType((count + 1) / 2 + 1));
    const void* halves = samples->GetPointer(0);
    field.samples = std::shared_ptr<const void>(halves, [samples](const void*) {});
    field.precision = FieldPrecision::float16;
}

}  // namespace aeolic
