#include "reader/vtk/part_blocks.h"

#include <fmt/format.h>
#include <vtkMultiBlockDataSet.h>

#include <algorithm>

#include "reader/vtk/block_arrays.h"
#include "reader/vtk/part_data_set.h"

namespace aeolic {
namespace {

/// Puts cells behind those of `all`, which has the same points with the same values.
void join(PartMesh& all, PartMesh part, const std::vector<PartArray>& arrays)
{
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        if (arrays[i].onPoints || (!all.values[i] && !part.values[i])) continue;
        const auto width = std::size_t(arrays[i].components);
        auto values = std::make_shared<std::vector<float>>();
        const auto add = [&](const PartMesh& mesh) {
            values->resize(values->size() + (mesh.values[i] ? 0 : mesh.cellCount() * width), std::nanf(""));
            if (mesh.values[i]) values->insert(values->end(), mesh.values[i]->begin(), mesh.values[i]->end());
        };
        add(all);
        add(part);
        all.values[i] = values;
    }
    std::move(part.cells.begin(), part.cells.end(), std::back_inserter(all.cells));
}

}  // namespace

PartBlocks::PartBlocks(std::unique_ptr<PartSource> source, const std::string& path, FileUse use)
    : OwnReader(path, use), source_(std::move(source))
{
    times_ = source_->times();
    for (const PartArray& array : source_->arrays())
        arrays_.push_back({array.name, array.onPoints, array.components, vtkTypeOf(array.type)});
}

void PartBlocks::keepParts(const std::vector<std::string>& wanted)
{
    OwnReader::keepParts(wanted);
    const std::string usual = source_->usualVectors(chosen());
    for (ArrayInfo& array : arrays_) array.activeVectors = !usual.empty() && array.name == usual;
}

vtkSmartPointer<vtkDataObject> PartBlocks::readPieces(const std::vector<ArrayInfo>& kept, const PieceRun& run)
{
    source_->keepPieces(run);
    const auto blocks = read(kept);
    return vtkMultiBlockDataSet::SafeDownCast(blocks)->GetBlock(0);
}

vtkSmartPointer<vtkDataObject> PartBlocks::read(const std::vector<ArrayInfo>& kept)
{
    std::vector<PartArray> arrays;
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < source_->arrays().size(); ++i) {
        const PartArray& array = source_->arrays()[i];
        if (!findInfo(kept, array.name, array.onPoints)) continue;
        arrays.push_back(array);
        wanted.push_back(i);
    }
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    const auto add = [&](PartMesh mesh, const PartInfo& part) {
        const std::string where = fmt::format("{}: '{}'", path_, part.name);
        addBlock(*blocks, dataSetOf(std::move(mesh), part.dimension, arrays, where), part.name);
    };
    const std::vector<PartInfo>& parts = source_->parts();
    std::vector<std::size_t> some = chosen();
    if (use_ == FileUse::field) std::erase_if(some, [&](std::size_t i) { return parts[i].dimension != 3; });
    if (auto all = some.empty() ? std::nullopt : source_->readTogether(some, wanted)) {
        add(std::move(*all), parts[some.front()]);
        return blocks;
    }
    PartMesh joined;
    const PartInfo* first = nullptr;
    for (const std::size_t i : some) {
        const PartInfo& part = parts[i];
        PartMesh mesh = source_->read(i, wanted);
        if (use_ != FileUse::field || !mesh.shared) {
            add(std::move(mesh), part);
        } else if (!first) {
            joined = std::move(mesh);
            first = &part;
        } else {
            join(joined, std::move(mesh), arrays);
        }
    }
    if (first) add(std::move(joined), *first);
    return blocks;
}

}  // namespace aeolic
