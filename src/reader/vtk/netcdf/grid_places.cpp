#include "reader/vtk/netcdf/grid_places.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/text.h"
#include "reader/vtk/block_arrays.h"
#include "reader/vtk/netcdf/grid_values.h"

namespace aeolic {
namespace {

/// Steps along a line are even if they differ by no more than this share of a step: coordinates are often floats.
constexpr double kEvenness = 1e-3;

/// Whether it is longitude or latitude, and not that of a grid with a pole of its own.
bool isOfMap(const NetcdfFile& file, const std::optional<std::string>& variable)
{
    if (!variable) return false;
    const std::string name = file.text(*variable, "standard_name").value_or("");
    return isInDegrees(file, *variable) && !name.starts_with("grid_");
}

/// Makes longitudes that pass 360 and begin again at 0 go on beyond 360.
void unwind(std::vector<double>& places)
{
    for (std::size_t i = 1; i < places.size(); ++i) places[i] -= 360 * std::round((places[i] - places[i - 1]) / 360);
}

/// The coordinates along a dimension; 0, 1 … where there are none.
std::vector<double> lineOf(const NetcdfFile& file, const std::string& dimension, CoordinateKind kind, bool& turned)
{
    const auto name = coordinateOf(file, dimension, kind);
    std::vector<double> line(file.dimension(dimension).value_or(0));
    std::iota(line.begin(), line.end(), 0.0);
    if (!name || file.shape(*name)[0] != line.size()) return line;
    line = file.read<double>(*name);
    if (kind == CoordinateKind::x && isInDegrees(file, *name)) unwind(line);
    if (kind == CoordinateKind::z && lowerCase(file.text(*name, "positive").value_or("")) == "down")
        for (double& place : line) place = -place;
    turned = line.size() > 1 && line[1] < line[0];
    if (turned) std::ranges::reverse(line);
    for (std::size_t i = 0; i < line.size(); ++i)
        if (!std::isfinite(line[i]) || (i > 0 && line[i] <= line[i - 1]))
            file.fail(fmt::format("its coordinate '{}' has the values {} and {} beside each other", *name,
                                  line[i > 0 ? i - 1 : 0], line[i]),
                      "finite values that only grow or only shrink");
    return line;
}

/// The values of a variable over y and x. Of one that changes in time they are those of the first step.
std::vector<double> planeValues(const NetcdfFile& file, const std::string& name)
{
    Slab slab = wholeSlab(file.shape(name));
    std::fill(slab.count.begin(), slab.count.end() - 2, 1);
    const std::vector<float> values = unpackedValues(file, name, slab);
    return {values.begin(), values.end()};
}

/// Whether the values differ. In idealized runs all longitudes and latitudes are zero.
bool hasExtent(const std::vector<double>& values)
{
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const double value : values)
        if (std::isfinite(value)) {
            lo = std::min(lo, value);
            hi = std::max(hi, value);
        }
    return hi > lo;
}

/// Makes neighbours on a curvilinear grid neighbours on the map, also where the grid crosses the map's edge.
void unwindRows(GridPlaces& places)
{
    std::vector<double> row(places.columns());
    double first = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t r = 0; r < places.rows(); ++r) {
        double before = first;
        bool isFirst = true;
        for (std::size_t c = 0; c < row.size(); ++c) {
            double& place = places.x[r * row.size() + c];
            if (!std::isfinite(place)) continue;
            if (std::isfinite(before)) place -= 360 * std::round((place - before) / 360);
            before = place;
            if (isFirst) first = place;
            isFirst = false;
        }
    }
}

bool isEven(const std::vector<double>& line)
{
    const double step = line.size() < 2 ? 1 : (line.back() - line.front()) / double(line.size() - 1);
    for (std::size_t i = 0; i < line.size(); ++i)
        if (std::abs(line[i] - line.front() - double(i) * step) > kEvenness * step) return false;
    return true;
}

vtkSmartPointer<vtkDataSet> imageOf(const GridPlaces& places)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(int(places.columns()), int(places.rows()), int(places.layers()));
    double origin[3], spacing[3] = {1, 1, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<double>& line = places.lines[c];
        origin[c] = line.front();
        if (line.size() > 1) spacing[c] = (line.back() - line.front()) / double(line.size() - 1);
    }
    image->SetOrigin(origin);
    image->SetSpacing(spacing);
    return image;
}

/// Whether a cell of a curvilinear grid has no place on the map.
bool isTorn(const GridPlaces& places, std::size_t row, std::size_t column)
{
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const std::size_t corner : {row * places.columns() + column, (row + 1) * places.columns() + column})
        for (const std::size_t at : {corner, corner + 1}) {
            if (!std::isfinite(places.x[at]) || !std::isfinite(places.y[at])) return true;
            lo = std::min(lo, places.x[at]);
            hi = std::max(hi, places.x[at]);
        }
    return places.inDegrees && hi - lo > 180;
}

vtkSmartPointer<vtkDataSet> curvilinearOf(const GridPlaces& places)
{
    const std::size_t columns = places.columns(), rows = places.rows(), layers = places.layers();
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(int(columns), int(rows), int(layers));
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetNumberOfPoints(vtkIdType(places.count()));
    double known[2] = {0, 0};  // Points without a place are put beside one that has one; their cells are hidden.
    for (std::size_t i = 0; i < rows * columns; ++i)
        if (std::isfinite(places.x[i]) && std::isfinite(places.y[i])) {
            known[0] = places.x[i];
            known[1] = places.y[i];
            break;
        }
    for (std::size_t k = 0; k < layers; ++k)
        for (std::size_t i = 0; i < rows * columns; ++i) {
            if (std::isfinite(places.x[i]) && std::isfinite(places.y[i])) {
                known[0] = places.x[i];
                known[1] = places.y[i];
            }
            points->SetPoint(vtkIdType(k * rows * columns + i), known[0], known[1], places.lines[2][k]);
        }
    grid->SetPoints(points);
    auto hidden = vtkSmartPointer<vtkUnsignedCharArray>::New();
    hidden->SetName(vtkDataSetAttributes::GhostArrayName());
    hidden->SetNumberOfValues(grid->GetNumberOfCells());
    bool any = false;
    for (std::size_t cell = 0; cell < std::size_t(grid->GetNumberOfCells()); ++cell) {
        const std::size_t inLayer = cell % ((rows - 1) * (columns - 1));
        const bool torn = isTorn(places, inLayer / (columns - 1), inLayer % (columns - 1));
        hidden->SetValue(vtkIdType(cell), torn ? vtkDataSetAttributes::HIDDENCELL : 0);
        any = any || torn;
    }
    if (any) grid->GetCellData()->AddArray(hidden);
    return grid;
}

}  // namespace

double GridPlaces::xAt(std::size_t row, std::size_t column) const
{
    return isCurvilinear() ? x[row * columns() + column] : lines[0][column];
}

double GridPlaces::yAt(std::size_t row, std::size_t column) const
{
    return isCurvilinear() ? y[row * columns() + column] : lines[1][row];
}

GridPlaces placesOf(const NetcdfFile& file, const GridAxes& axes, const std::string& variable)
{
    GridPlaces places;
    places.lines[2] = {0};
    const auto x = coordinateOf(file, axes.back(), CoordinateKind::x),
               y = coordinateOf(file, axes[axes.size() - 2], CoordinateKind::y);
    places.inDegrees = x && y && isInDegrees(file, *x) && isInDegrees(file, *y);
    for (std::size_t c = 0; c < axes.size(); ++c)
        places.lines[c] = lineOf(file, axes[axes.size() - 1 - c], kKindOfAxis[c], places.turned[c]);
    const auto plane = planeOf(file, axes, variable);
    if (!plane || (!plane->areNamed && isOfMap(file, x) && isOfMap(file, y))) return places;
    std::vector<double> xs = planeValues(file, plane->x), ys = planeValues(file, plane->y);
    if (xs.size() != places.rows() * places.columns() || xs.size() != ys.size() || !hasExtent(xs) || !hasExtent(ys))
        return places;
    places.x = std::move(xs);
    places.y = std::move(ys);
    places.turned[0] = places.turned[1] = false;
    places.inDegrees = isInDegrees(file, plane->x) && isInDegrees(file, plane->y);
    if (places.inDegrees) unwindRows(places);
    return places;
}

vtkSmartPointer<vtkDataSet> dataSetOf(const GridPlaces& places)
{
    if (places.isCurvilinear()) return curvilinearOf(places);
    if (std::ranges::all_of(places.lines, isEven)) return imageOf(places);
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(int(places.columns()), int(places.rows()), int(places.layers()));
    grid->SetXCoordinates(arrayOf<vtkDoubleArray>("x", 1, places.lines[0]));
    grid->SetYCoordinates(arrayOf<vtkDoubleArray>("y", 1, places.lines[1]));
    grid->SetZCoordinates(arrayOf<vtkDoubleArray>("z", 1, places.lines[2]));
    return grid;
}

}  // namespace aeolic
