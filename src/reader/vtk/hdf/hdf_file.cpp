#include "reader/vtk/format_readers.h"

#include <fmt/format.h>
#include <vtkMultiBlockDataSet.h>

#include <algorithm>
#include <map>
#include <utility>

#include "aeolic/error.h"
#include "reader/vtk/block_arrays.h"
#include "reader/vtk/hdf/hdf_data_set.h"

namespace aeolic {
namespace {

bool isComposite(const std::string& type)
{
    return type == "PartitionedDataSetCollection" || type == "MultiBlockDataSet";
}

class VtkHdfFile : public OwnReader {
public:
    VtkHdfFile(const std::string& path, FileUse use, std::optional<double> time) : OwnReader(path, use)
    {
        const Hdf5Object root = Hdf5Object::openFile(path);
        const auto group = root.find("VTKHDF");
        if (!group || group->isDataSet())
            throw InputError(path, "it is an HDF5 file, but not one of VTK", "a group 'VTKHDF'");
        const auto version = group->wholeNumbers("Version");
        if (!version || version->empty() || version->front() < 0 || version->front() > 2)
            group->fail(
                fmt::format("its version is {}", version ? fmt::format("{}", fmt::join(*version, ".")) : "not told"),
                "1 or 2");
        if (isComposite(group->text("Type").value_or("")))
            findBlocks(*group);
        else
            sets_.emplace_back(*group);
        for (const HdfDataSet& set : sets_) {
            if (times_.size() < set.times().size()) times_ = set.times();
            addOthers(arrays_, set.arrays());
        }
        time_ = time.value_or(times_.empty() ? 0 : times_.front());
    }

    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) override
    {
        if (parts_.empty()) return readSet(sets_.front(), kept);
        auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        for (const std::size_t i : chosen()) addBlock(*blocks, readSet(sets_[i], kept), parts_[i].name);
        return blocks;
    }

private:
    /// Blocks are groups beside the assembly, a tree of names whose leaves are links to them. A link's name is that of
    /// the block in a MultiBlockDataSet.
    void findBlocks(const Hdf5Object& group)
    {
        const bool namedByLinks = group.text("Type") == "MultiBlockDataSet";
        std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> numbers;
        for (const std::string& name : group.names()) {
            if (name == "Assembly") continue;
            const auto block = group.find(name);
            if (!block || block->isDataSet() || !block->text("Type")) continue;
            numbers[block->identity()] = sets_.size();
            sets_.emplace_back(*block);
            const bool polygons = sets_.back().type() == "PolyData";
            parts_.push_back({name,
                              polygons                             ? "polygons"
                              : sets_.back().type() == "ImageData" ? "image data"
                                                                   : "an unstructured grid",
                              {},
                              polygons ? 2 : 3});
        }
        if (sets_.empty()) group.fail("it has no blocks", "groups of a type");
        const auto leaf = [&](const Hdf5Object& block, const std::string& name, const std::vector<std::string>& above) {
            const auto number = numbers.find(block.identity());
            if (number == numbers.end()) return;
            PartInfo& part = parts_[number->second];
            if (namedByLinks) part.name = name;
            part.groups.insert(part.groups.end(), above.begin(), above.end());
        };
        if (const auto assembly = group.find("Assembly")) walkAssembly(*assembly, {}, leaf);
    }

    template <class Leaf>
    static void walkAssembly(const Hdf5Object& at, const std::vector<std::string>& above, const Leaf& leaf)
    {
        for (const std::string& name : at.names()) {
            const auto child = at.find(name);
            if (!child || child->isDataSet()) continue;
            if (child->text("Type")) {
                leaf(*child, name, above);
                continue;
            }
            std::vector<std::string> within = above;
            within.push_back(name);
            walkAssembly(*child, within, leaf);
        }
    }

    vtkSmartPointer<vtkDataSet> readSet(const HdfDataSet& set, const std::vector<ArrayInfo>& kept) const
    {
        std::size_t step = 0;
        for (std::size_t i = 0; i < set.times().size(); ++i)
            if (set.times()[i] <= time_) step = i;
        std::vector<ArrayInfo> own;
        for (const ArrayInfo& array : set.arrays())
            if (findInfo(kept, array.name, array.onPoints)) own.push_back(array);
        return set.read(step, own);
    }

    std::vector<HdfDataSet> sets_;  // Each is a part, where there are several.
    double time_ = 0;
};

}  // namespace

std::unique_ptr<OwnReader> openVtkHdf(const std::string& path, FileUse use, std::optional<double> time)
{
    return std::make_unique<VtkHdfFile>(path, use, time);
}

}  // namespace aeolic
