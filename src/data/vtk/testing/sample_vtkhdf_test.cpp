#include "data/vtk/testing/sample_vtkhdf.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <map>

#include "reader/hdf5/testing/sample_hdf5.h"

namespace aeolic::test {
namespace {

using Wholes = std::vector<std::int64_t>;
using Lengths = std::vector<std::uint64_t>;

/// Collects lists piece by piece, and writes them at the end.
class Lists {
public:
    Lists(Hdf5Writer& writer, const SampleVtkHdf& sample) : writer_(writer), sample_(sample) {}

    Wholes& wholes(const std::string& path) { return wholes_[path]; }

    /// The list, which then is not written.
    Wholes take(const std::string& path)
    {
        Wholes list = std::move(wholes_[path]);
        wholes_.erase(path);
        return list;
    }

    void add(const std::string& path, vtkDataArray& array)
    {
        auto& [width, floats, bytes, values] = reals_[path];
        width = array.GetNumberOfComponents();
        floats = array.GetDataType() == VTK_FLOAT;
        bytes = array.GetDataType() == VTK_UNSIGNED_CHAR;
        for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
            for (int c = 0; c < width; ++c) values.push_back(array.GetComponent(i, c));
    }

    void write() const
    {
        for (const auto& [path, values] : wholes_) data<std::int64_t>(path, {values.size()}, values);
        for (const auto& [path, list] : reals_) {
            Lengths shape{list.values.size() / std::size_t(list.width)};
            if (list.width > 1) shape.push_back(std::uint64_t(list.width));
            writeReals(path, shape, list.values, list.floats, list.bytes);
        }
    }

    void writeReals(const std::string& path, const Lengths& shape, const std::vector<double>& values, bool floats,
                    bool bytes) const
    {
        if (floats)
            data<float>(path, shape, {values.begin(), values.end()});
        else if (bytes)
            data<std::uint8_t>(path, shape, {values.begin(), values.end()});
        else
            data<double>(path, shape, values);
    }

private:
    struct Reals {
        int width = 1;
        bool floats = true, bytes = false;
        std::vector<double> values;
    };

    template <class Number>
    void data(const std::string& path, const Lengths& shape, const std::vector<Number>& values) const
    {
        Hdf5SampleLayout layout;
        if (sample_.packed && !values.empty()) {
            layout.chunk = shape;
            for (std::uint64_t& length : layout.chunk) length = std::min<std::uint64_t>(length, 7);
            layout.most = shape;
            layout.most[0] = ~std::uint64_t{0};
            layout.deflate = layout.shuffle = true;
        }
        writer_.data<Number>(path, shape, values, layout);
    }

    Hdf5Writer& writer_;
    const SampleVtkHdf& sample_;
    std::map<std::string, Wholes> wholes_;
    std::map<std::string, Reals> reals_;
};

template <class Take>
void forEachArray(vtkDataSet& set, const Take& take)
{
    for (const bool onPoints : {true, false}) {
        vtkDataSetAttributes* all =
            onPoints ? static_cast<vtkDataSetAttributes*>(set.GetPointData()) : set.GetCellData();
        for (int i = 0; i < all->GetNumberOfArrays(); ++i)
            take(std::string(onPoints ? "PointData/" : "CellData/"), *all->GetArray(i));
    }
}

void writeImages(Hdf5Writer& writer, const std::string& root, const std::vector<vtkSmartPointer<vtkDataSet>>& sets,
                 const SampleVtkHdf& sample, const Lists& lists)
{
    auto& image = *vtkImageData::SafeDownCast(sets.front());
    const int* extent = image.GetExtent();
    writer.attribute<std::int64_t>(root, "WholeExtent", {extent, extent + 6});
    writer.attribute<double>(root, "Origin", {image.GetOrigin(), image.GetOrigin() + 3});
    writer.attribute<double>(root, "Spacing", {image.GetSpacing(), image.GetSpacing() + 3});
    const double* direction = image.GetDirectionMatrix()->GetData();
    writer.attribute<double>(root, "Direction", {direction, direction + 9});
    forEachArray(image, [&](const std::string& folder, vtkDataArray& first) {
        Lengths shape;
        if (sample.steps) shape.push_back(sets.size());
        for (int c = 2; c >= 0; --c) {
            const int samples = extent[2 * c + 1] - extent[2 * c] + 1;
            shape.push_back(std::uint64_t(folder == "PointData/" ? samples : std::max(samples - 1, 1)));
        }
        if (first.GetNumberOfComponents() > 1) shape.push_back(std::uint64_t(first.GetNumberOfComponents()));
        std::vector<double> values;
        for (const auto& set : sets)
            forEachArray(*set, [&](const std::string& each, vtkDataArray& array) {
                if (each != folder || std::string(array.GetName()) != first.GetName()) return;
                for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
                    for (int c = 0; c < array.GetNumberOfComponents(); ++c) values.push_back(array.GetComponent(i, c));
            });
        lists.writeReals(root + "/" + folder + first.GetName(), shape, values, first.GetDataType() == VTK_FLOAT,
                         first.GetDataType() == VTK_UNSIGNED_CHAR);
    });
}

void addCells(Lists& lists, const std::string& folder, vtkCellArray& cells)
{
    lists.wholes(folder + "NumberOfCells").push_back(cells.GetNumberOfCells());
    lists.wholes(folder + "NumberOfConnectivityIds").push_back(cells.GetNumberOfConnectivityIds());
    Wholes &corners = lists.wholes(folder + "Connectivity"), &offsets = lists.wholes(folder + "Offsets");
    std::int64_t end = 0;
    offsets.push_back(0);
    for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell) {
        vtkIdType size = 0;
        const vtkIdType* own = nullptr;
        cells.GetCellAtId(cell, size, own);
        corners.insert(corners.end(), own, own + size);
        offsets.push_back(end += size);
    }
}

void addGeometry(Lists& lists, const std::string& root, vtkDataSet& set)
{
    auto& points = *vtkPointSet::SafeDownCast(&set);
    lists.wholes(root + "/NumberOfPoints").push_back(points.GetNumberOfPoints());
    lists.add(root + "/Points", *points.GetPoints()->GetData());
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&set)) {
        addCells(lists, root + "/", *grid->GetCells());
        lists.add(root + "/Types", *grid->GetCellTypesArray());
        return;
    }
    auto& polygons = *vtkPolyData::SafeDownCast(&set);
    addCells(lists, root + "/Vertices/", *polygons.GetVerts());
    addCells(lists, root + "/Lines/", *polygons.GetLines());
    addCells(lists, root + "/Polygons/", *polygons.GetPolys());
    addCells(lists, root + "/Strips/", *polygons.GetStrips());
}

/// How many of everything stand in front of a step.
void addStep(Lists& lists, const std::string& root, vtkDataSet& set, const SampleVtkHdf& sample, std::int64_t step)
{
    const std::string steps = root + "/Steps/";
    const auto count = [&](const std::string& list) {
        return sample.still ? 0 : std::int64_t(lists.wholes(list).size());
    };
    const auto sum = [&](const std::string& list) {
        std::int64_t total = 0;
        for (const std::int64_t each : lists.wholes(list)) total += each;
        return sample.still ? 0 : total;
    };
    lists.wholes(steps + "PartOffsets").push_back(count(root + "/NumberOfPoints"));
    lists.wholes(steps + "NumberOfParts").push_back(1);
    lists.wholes(steps + "PointOffsets").push_back(sum(root + "/NumberOfPoints"));
    const std::vector<std::string> kinds = vtkPolyData::SafeDownCast(&set)
                                               ? std::vector<std::string>{"/Vertices", "/Lines", "/Polygons", "/Strips"}
                                               : std::vector<std::string>{""};
    for (const std::string& kind : kinds) {
        lists.wholes(steps + "CellOffsets").push_back(sum(root + kind + "/NumberOfCells"));
        lists.wholes(steps + "ConnectivityIdOffsets").push_back(sum(root + kind + "/NumberOfConnectivityIds"));
    }
    if (!sample.offsets) return;
    forEachArray(set, [&](const std::string& folder, vtkDataArray& array) {
        const std::string kind = folder.substr(0, folder.size() - 1);
        lists.wholes(steps + kind + "Offsets/" + array.GetName()).push_back(step * array.GetNumberOfTuples());
    });
}

void writeSet(Hdf5Writer& writer, const std::string& root, const std::vector<vtkSmartPointer<vtkDataSet>>& sets,
              const SampleVtkHdf& sample)
{
    vtkDataSet& first = *sets.front();
    const bool image = vtkImageData::SafeDownCast(&first), polygons = vtkPolyData::SafeDownCast(&first);
    writer.group(root);
    writer.text(root, "Type", image ? "ImageData" : polygons ? "PolyData" : "UnstructuredGrid");
    writer.attribute<std::int64_t>(root, "Version", {2, 1});
    Lists lists(writer, sample);
    if (sample.steps) {
        writer.group(root + "/Steps");
        writer.attribute<std::int64_t>(root + "/Steps", "NSteps", {std::int64_t(sets.size())});
        std::vector<double> times;
        for (std::size_t i = 0; i < sets.size(); ++i) times.push_back(0.5 * double(i));
        writer.data<double>(root + "/Steps/Values", {times.size()}, times);
    }
    if (image) {
        writeImages(writer, root, sets, sample, lists);
        return;
    }
    std::int64_t number = 0;
    for (const auto& set : sets) {
        if (sample.steps) addStep(lists, root, *set, sample, number);
        if (number == 0 || !sample.still) addGeometry(lists, root, *set);
        forEachArray(*set, [&](const std::string& folder, vtkDataArray& array) {
            lists.add(root + "/" + folder + array.GetName(), array);
        });
        ++number;
    }
    if (sample.steps && polygons)  // A column for each of the four kinds of cells.
        for (const char* name : {"/Steps/CellOffsets", "/Steps/ConnectivityIdOffsets"}) {
            writer.data<std::int64_t>(root + name, {sets.size(), 4}, lists.take(root + name));
        }
    lists.write();
}

}  // namespace

void writeVtkHdf(const std::string& path, const std::vector<vtkSmartPointer<vtkDataSet>>& sets,
                 const SampleVtkHdf& sample)
{
    Hdf5Writer writer(path, sample.newest);
    writeSet(writer, "/VTKHDF", sets, sample);
}

void writeVtkHdfBlocks(const std::string& path, const std::vector<vtkSmartPointer<vtkDataSet>>& sets)
{
    Hdf5Writer writer(path);
    writer.group("/VTKHDF", true);
    writer.text("/VTKHDF", "Type", "PartitionedDataSetCollection");
    writer.attribute<std::int64_t>("/VTKHDF", "Version", {2, 1});
    for (std::size_t i = 0; i < sets.size(); ++i) writeSet(writer, "/VTKHDF/block" + std::to_string(i), {sets[i]}, {});
    for (const char* group : {"/VTKHDF/Assembly/all/even", "/VTKHDF/Assembly/all/odd"}) writer.group(group, true);
    for (std::size_t i = 0; i < sets.size(); ++i)
        writer.softLink(
            std::string("/VTKHDF/Assembly/all/") + (i % 2 == 0 ? "even" : "odd") + "/block" + std::to_string(i),
            "/VTKHDF/block" + std::to_string(i));
}

}  // namespace aeolic::test
