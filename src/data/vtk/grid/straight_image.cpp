#include "data/vtk/grid/straight_image.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <utility>

#include "base/memory.h"
#include "data/vtk/arrays.h"

namespace aeolic {
namespace {

/// Steps of an image's indices in the world.
struct Axes {
    std::array<glm::dvec3, 3> steps;
    std::array<int, 3> dims;
    glm::dvec3 first;  // Where its first sample is.
};

/// Nothing where the image has no sound axes.
std::optional<Axes> axesOf(vtkImageData& image)
{
    Axes axes;
    image.GetDimensions(axes.dims.data());
    const int* extent = image.GetExtent();
    axes.first = {image.GetOrigin()[0], image.GetOrigin()[1], image.GetOrigin()[2]};
    for (int c = 0; c < 3; ++c) {
        const bool isFlat = axes.dims[std::size_t(c)] < 2;
        const double spacing = isFlat && image.GetSpacing()[c] == 0 ? 1 : image.GetSpacing()[c];
        glm::dvec3& step = axes.steps[std::size_t(c)];
        for (int k = 0; k < 3; ++k) step[k] = image.GetDirectionMatrix()->GetElement(k, c) * spacing;
        axes.first += double(extent[2 * c]) * step;
        if (!(glm::length(step) > 0) || !std::isfinite(glm::length(step))) return std::nullopt;
    }
    return axes;
}

/// Which axis of the world each of the image's runs along, up or down; nothing where one runs along none.
struct Turn {
    std::array<std::size_t, 3> axis;
    std::array<bool, 3> isDown;
};

std::optional<Turn> turnOf(const Axes& axes)
{
    constexpr double kHair = 1e-9;
    Turn turn{};
    std::array<bool, 3> taken{};
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec3& step = axes.steps[c];
        std::size_t along = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (std::abs(step[int(k)]) > std::abs(step[int(along)])) along = k;
        for (std::size_t k = 0; k < 3; ++k)
            if (k != along && std::abs(step[int(k)]) > kHair * glm::length(step)) return std::nullopt;
        if (std::exchange(taken[along], true)) return std::nullopt;
        turn.axis[c] = along;
        turn.isDown[c] = step[int(along)] < 0;
    }
    return turn;
}

/// Values in another order: of samples or cells, of which `dims` are in each direction.
void reorder(vtkDataSetAttributes& from, vtkDataSetAttributes& to, const std::array<int, 3>& dims, const Turn& turn)
{
    std::array<vtkIdType, 3> straight{}, steps{};  // How many in x, y and z, and how far one is from the next.
    vtkIdType step = 1, begin = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        straight[turn.axis[c]] = dims[c];
        steps[turn.axis[c]] = turn.isDown[c] ? -step : step;
        if (turn.isDown[c]) begin += step * (dims[c] - 1);
        step *= dims[c];
    }
    vtkNew<vtkIdList> sources;
    sources->SetNumberOfIds(step);
    vtkIdType* next = sources->begin();
    for (vtkIdType z = 0; z < straight[2]; ++z)
        for (vtkIdType y = 0; y < straight[1]; ++y)
            for (vtkIdType x = 0; x < straight[0]; ++x) *next++ = begin + x * steps[0] + y * steps[1] + z * steps[2];
    takeTuples(from, *sources, to);
}

std::array<int, 3> cellDims(const std::array<int, 3>& dims)
{
    return {std::max(1, dims[0] - 1), std::max(1, dims[1] - 1), std::max(1, dims[2] - 1)};
}

vtkSmartPointer<vtkDataSet> turnedImage(vtkImageData& image, const Axes& axes, const Turn& turn)
{
    auto straight = vtkSmartPointer<vtkImageData>::New();
    std::array<int, 3> dims{};
    glm::dvec3 origin = axes.first, spacing{1};
    for (std::size_t c = 0; c < 3; ++c) {
        dims[turn.axis[c]] = axes.dims[c];
        spacing[int(turn.axis[c])] = glm::length(axes.steps[c]);
        if (turn.isDown[c]) origin[int(turn.axis[c])] -= (axes.dims[c] - 1) * spacing[int(turn.axis[c])];
    }
    straight->SetDimensions(dims.data());
    straight->SetOrigin(&origin.x);
    straight->SetSpacing(&spacing.x);
    reorder(*image.GetPointData(), *straight->GetPointData(), axes.dims, turn);
    reorder(*image.GetCellData(), *straight->GetCellData(), cellDims(axes.dims), turn);
    return straight;
}

vtkSmartPointer<vtkDataSet> structuredGrid(vtkImageData& image, const Axes& axes)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(image.GetNumberOfPoints());
    vtkIdType next = 0;
    for (int k = 0; k < axes.dims[2]; ++k)
        for (int j = 0; j < axes.dims[1]; ++j)
            for (int i = 0; i < axes.dims[0]; ++i) {
                const glm::dvec3 p =
                    axes.first + double(i) * axes.steps[0] + double(j) * axes.steps[1] + double(k) * axes.steps[2];
                points->SetPoint(next++, &p.x);
            }
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(axes.dims.data());
    grid->SetPoints(points);
    grid->GetPointData()->ShallowCopy(image.GetPointData());
    grid->GetCellData()->ShallowCopy(image.GetCellData());
    return grid;
}

}  // namespace

vtkSmartPointer<vtkDataSet> straightened(vtkDataSet& data, const std::string& path)
{
    auto* image = vtkImageData::SafeDownCast(&data);
    if (!image || image->GetNumberOfPoints() == 0) return &data;
    const double* spacing = image->GetSpacing();
    const bool isStraight =
        image->GetDirectionMatrix()->IsIdentity() && spacing[0] >= 0 && spacing[1] >= 0 && spacing[2] >= 0;
    const auto axes = isStraight ? std::nullopt : axesOf(*image);
    if (!axes) return &data;
    requireMemory(path, "turning its axes", 48 * std::uint64_t(image->GetNumberOfPoints()));
    const auto turn = turnOf(*axes);
    return turn ? turnedImage(*image, *axes, *turn) : structuredGrid(*image, *axes);
}

}  // namespace aeolic
