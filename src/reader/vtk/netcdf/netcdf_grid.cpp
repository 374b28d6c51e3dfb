#include "reader/vtk/format_readers.h"

#include <fmt/format.h>
#include <vtkPointData.h>

#include <algorithm>

#include "base/memory.h"
#include "reader/netcdf/netcdf_file.h"
#include "reader/vtk/block_arrays.h"
#include "reader/vtk/netcdf/grid_places.h"
#include "reader/vtk/netcdf/grid_values.h"
#include "reader/vtk/netcdf/grid_variables.h"

namespace aeolic {
namespace {

constexpr std::uint64_t kMostPoints = std::uint64_t(1) << 31;
/// So many more floats are in memory for each point while an array is made: its place, packed numbers and a copy.
constexpr std::uint64_t kFloatsBeside = 9;

class NetcdfGrid : public OwnReader {
public:
    NetcdfGrid(const std::string& path, FileUse use, std::optional<double> time)
        : OwnReader(path, use), file_(path), all_(gridVariablesOf(file_))
    {
        // The first vector is proposed first, so it belongs to the grid that all arrays together get.
        std::ranges::stable_sort(all_.vectors, [&](const GridVector& a, const GridVector& b) {
            if (a.isFlow != b.isFlow) return a.isFlow;
            return pointsOf(a.axes) > pointsOf(b.axes);
        });
        // First the vectors, then the variables.
        for (const GridVector& vector : all_.vectors) arrays_.push_back({vector.name, true, 3, VTK_FLOAT});
        for (const GridVariable& variable : all_.variables) arrays_.push_back({variable.name, true, 1, VTK_FLOAT});
        for (const GridVariable& variable : all_.variables) steps_.push_back(stepAt(variable, time));
        // The times of the grid that is read if all arrays are kept.
        if (const auto name = timeOf(all_.variables[variableOf(leading(arrays_))])) times_ = all_.times.at(*name);
    }

    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) override
    {
        const std::size_t first = leading(kept);
        const GridAxes& axes = axesOf(first);
        const GridPlaces places = placesOf(file_, axes, all_.variables[variableOf(first)].name);
        if (places.count() > kMostPoints)
            file_.fail(fmt::format("a grid of {} points", places.count()), "at most 2^31");
        std::uint64_t floats = kFloatsBeside;
        for (const ArrayInfo& array : kept) floats += std::uint64_t(array.components);
        requireMemory(file_.path(),
                      fmt::format("a grid of {} x {} x {} points", places.columns(), places.rows(), places.layers()),
                      places.count() * sizeof(float) * floats);
        const auto data = dataSetOf(places);
        for (const ArrayInfo& array : kept) {
            const std::size_t i = indexOf(array);
            if (i == arrays_.size()) continue;
            if (!canStandOn(file_, axesOf(i), axes)) {
                if (kept.size() == arrays_.size()) continue;  // Nobody asked for this one.
                file_.fail(fmt::format("'{}' stands on another grid than '{}'", array.name, arrays_[first].name),
                           "arrays of one grid");
            }
            const std::vector<float> values = i < all_.vectors.size()
                                                  ? vectorsOnGrid(file_, all_, all_.vectors[i], axes, places, steps_)
                                                  : valuesOnGrid(file_, all_.variables[i - all_.vectors.size()], axes,
                                                                 places, steps_[i - all_.vectors.size()]);
            data->GetPointData()->AddArray(arrayOf<vtkFloatArray>(array.name, array.components, values));
        }
        return data;
    }

private:
    std::size_t indexOf(const ArrayInfo& array) const
    {
        return std::size_t(
            std::ranges::find_if(arrays_, [&](const ArrayInfo& each) { return each.name == array.name; }) -
            arrays_.begin());
    }

    const GridAxes& axesOf(std::size_t array) const
    {
        return array < all_.vectors.size() ? all_.vectors[array].axes
                                           : all_.variables[array - all_.vectors.size()].axes;
    }

    /// The variable that an array is made of. A vector is made of several, of which this is the first.
    std::size_t variableOf(std::size_t array) const
    {
        return array < all_.vectors.size() ? all_.vectors[array].of[0] : array - all_.vectors.size();
    }

    std::uint64_t pointsOf(const GridAxes& axes) const
    {
        std::uint64_t points = 1;
        for (const std::string& axis : axes) points *= file_.dimension(axis).value_or(1);
        return points;
    }

    /// The array whose grid is read: the vector with the most points, or the scalar where no vector is kept.
    std::size_t leading(const std::vector<ArrayInfo>& kept) const
    {
        std::size_t best = 0;
        std::uint64_t most = 0;
        for (std::size_t i = 0; i < arrays_.size(); ++i) {
            if (i >= all_.vectors.size() && best < all_.vectors.size() && most > 0) break;
            if (std::ranges::none_of(kept, [&](const ArrayInfo& each) { return each.name == arrays_[i].name; }))
                continue;
            const std::uint64_t points = pointsOf(axesOf(i));
            if (points <= most) continue;
            best = i;
            most = points;
        }
        return best;
    }

    std::optional<std::string> timeOf(const GridVariable& variable) const
    {
        return variable.time ? std::optional(file_.dimensions(variable.name)[*variable.time]) : std::nullopt;
    }

    std::size_t stepAt(const GridVariable& variable, std::optional<double> time) const
    {
        const auto name = timeOf(variable);
        if (!name || !time) return 0;
        const std::vector<double>& times = all_.times.at(*name);
        const auto after = std::upper_bound(times.begin(), times.end(), *time);
        return after == times.begin() ? 0 : std::size_t(after - times.begin()) - 1;
    }

    NetcdfFile file_;
    GridVariables all_;
    std::vector<std::size_t> steps_;  // Which step of each variable is read.
};

}  // namespace

std::unique_ptr<OwnReader> openNetcdfGrid(const std::string& path, FileUse use, std::optional<double> time)
{
    return std::make_unique<NetcdfGrid>(path, use, time);
}

}  // namespace aeolic
