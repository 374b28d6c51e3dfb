#include "reader/vtk/hdf/hdf_data_set.h"

#include <fmt/format.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reader/vtk/block_arrays.h"

namespace aeolic {
namespace {

const char* groupName(bool onPoints)
{
    return onPoints ? "PointData" : "CellData";
}

/// Samples of the extent that an image says in x, y and z.
std::array<std::int64_t, 3> samplesOf(const Hdf5Object& group)
{
    const auto extent = group.wholeNumbers("WholeExtent");
    if (!extent || extent->size() != 6) group.fail("it has no WholeExtent", "six numbers");
    std::array<std::int64_t, 3> samples;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::int64_t first = (*extent)[2 * c], last = (*extent)[2 * c + 1];
        if (last < first || last > std::numeric_limits<int>::max() || first < std::numeric_limits<int>::min())
            group.fail(fmt::format("its WholeExtent is {}", fmt::join(*extent, " ")),
                       "first and last of each direction");
        samples[c] = last - first + 1;
    }
    return samples;
}

std::vector<double> realsOf(const Hdf5Object& group, const char* attribute, const std::vector<double>& expected)
{
    const auto values = group.reals(attribute);
    if (!values) return expected;
    if (values->size() != expected.size() ||
        !std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); }))
        group.fail(fmt::format("its {} is {}", attribute, fmt::join(*values, " ")),
                   fmt::format("{} finite numbers", expected.size()));
    return *values;
}

void addValues(vtkDataSet& to, const ArrayInfo& info, const Hdf5Object& data, const Slab& slab)
{
    vtkDataSetAttributes& all = *attributesOf(to, info.onPoints);
    if (isMaskName(info.name))
        all.AddArray(arrayOf<vtkUnsignedCharArray>(info.name, info.components, data.read<std::int8_t>(slab)));
    else
        all.AddArray(arrayOf<vtkFloatArray>(info.name, info.components, data.read<float>(slab)));
}

}  // namespace

HdfDataSet::HdfDataSet(const Hdf5Object& group) : group_(group), type_(group.text("Type").value_or(""))
{
    // Files of version 1.0 may not say it. Then there were but these two.
    if (type_.empty())
        type_ = group.wholeNumbers("WholeExtent") ? "ImageData" : group.has("Types") ? "UnstructuredGrid" : "";
    if (type_ != "ImageData" && type_ != "UnstructuredGrid" && type_ != "PolyData")
        group.fail(fmt::format("it is of the type '{}'", type_), "ImageData, UnstructuredGrid or PolyData");
    steps_ = group.find("Steps");
    if (steps_) {
        times_ = steps_->require("Values").read<double>();
        for (std::size_t i = 0; i < times_.size(); ++i)
            if (!std::isfinite(times_[i]) || (i > 0 && times_[i] <= times_[i - 1]))
                steps_->fail(fmt::format("its time {} is {}", i, times_[i]), "times that are finite and increase");
        if (times_.empty()) steps_->fail("it has no times", "one or more");
    }
    findArrays(true);
    findArrays(false);
}

void HdfDataSet::findArrays(bool onPoints)
{
    const auto all = group_.find(groupName(onPoints));
    if (!all) return;
    const std::size_t dimensions = type_ == "ImageData" ? (steps_ ? 4 : 3) : 1;
    for (const std::string& name : all->names()) {
        const auto data = all->find(name);
        if (!data || !data->type()) continue;
        const auto& shape = data->shape();
        if (shape.size() != dimensions && shape.size() != dimensions + 1) continue;
        const std::uint64_t components = shape.size() > dimensions ? shape.back() : 1;
        if (components < 1) continue;
        arrays_.push_back({name, onPoints, int(components), vtkTypeOf(*data->type()), all->text("Vectors") == name,
                           all->text("Normals") == name});
    }
}

vtkSmartPointer<vtkDataSet> HdfDataSet::read(std::size_t step, const std::vector<ArrayInfo>& kept) const
{
    if (type_ == "ImageData") return readImage(step, kept);
    return type_ == "PolyData" ? readPolygons(step, kept) : readGrid(step, kept);
}

vtkSmartPointer<vtkDataSet> HdfDataSet::readImage(std::size_t step, const std::vector<ArrayInfo>& kept) const
{
    const auto samples = samplesOf(group_);
    const auto extent = *group_.wholeNumbers("WholeExtent");
    auto image = vtkSmartPointer<vtkImageData>::New();
    int ends[6];
    for (std::size_t i = 0; i < 6; ++i) ends[i] = int(extent[i]);
    image->SetExtent(ends);
    image->SetOrigin(realsOf(group_, "Origin", {0, 0, 0}).data());
    image->SetSpacing(realsOf(group_, "Spacing", {1, 1, 1}).data());
    const auto direction = realsOf(group_, "Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
    vtkNew<vtkMatrix3x3> matrix;
    matrix->DeepCopy(direction.data());
    image->SetDirectionMatrix(matrix);
    for (const ArrayInfo& info : kept) {
        const Hdf5Object data = group_.require(groupName(info.onPoints)).require(info.name);
        std::vector<std::uint64_t> count;
        for (std::size_t c = 3; c-- > 0;)
            count.push_back(std::uint64_t(info.onPoints ? samples[c] : std::max<std::int64_t>(samples[c] - 1, 1)));
        Slab slab = wholeSlab(count);
        if (steps_) {
            slab.first.insert(slab.first.begin(), arrayBegin(info, step));
            slab.count.insert(slab.count.begin(), 1);
        }
        std::vector<std::uint64_t> shape = data.shape();
        if (shape.size() > slab.count.size()) {
            slab.first.push_back(0);
            slab.count.push_back(shape.back());
        }
        if (steps_) shape[0] = 1;
        if (shape != slab.count)
            data.fail(fmt::format("it has {} numbers", fmt::join(data.shape(), " x ")),
                      fmt::format("{}{}", steps_ ? "steps of " : "", fmt::join(count, " x ")));
        addValues(*image, info, data, slab);
    }
    return image;
}

/// Where an array's values of a step begin, of an image in steps.
std::uint64_t HdfDataSet::arrayBegin(const ArrayInfo& array, std::size_t step) const
{
    if (!steps_) return 0;
    const auto begins = steps_->find(std::string(groupName(array.onPoints)) + "Offsets/" + array.name);
    if (!begins) return type_ == "ImageData" ? step : ~std::uint64_t{0};
    const auto values = begins->read<std::int64_t>();
    if (step >= values.size() || values[step] < 0)
        begins->fail(fmt::format("it has {} numbers", values.size()), "one for each time, from 0 on");
    return std::uint64_t(values[step]);
}

/// `begin`: where values of the step begin, unless an array says that its own begin elsewhere.
void HdfDataSet::addArrays(vtkDataSet& to, std::size_t step, const std::vector<ArrayInfo>& kept,
                           const Place& begin) const
{
    for (const ArrayInfo& info : kept) {
        const Hdf5Object data = group_.require(groupName(info.onPoints)).require(info.name);
        std::uint64_t first = arrayBegin(info, step);
        if (!steps_ || first == ~std::uint64_t{0}) first = info.onPoints ? begin.point : begin.cell;
        const auto count = std::uint64_t(info.onPoints ? to.GetNumberOfPoints() : to.GetNumberOfCells());
        Slab slab{{first}, {count}};
        if (data.shape().size() > 1) {
            slab.first.push_back(0);
            slab.count.push_back(data.shape()[1]);
        }
        if (!isWithin(slab, data.shape()))
            data.fail(
                fmt::format("it has {} values", data.shape().front()),
                fmt::format("{} from {} on, one for each of the {}", count, first, info.onPoints ? "points" : "cells"));
        addValues(to, info, data, slab);
    }
}

}  // namespace aeolic
