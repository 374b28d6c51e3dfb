#include "reader/vtk/part_blocks.h"

#include <fmt/format.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkType.h>

#include <algorithm>

#include "data/part_choice.h"
#include "reader/vtk/part_data_set.h"

namespace aeolic {
namespace {

int vtkTypeOf(NumberType type)
{
    constexpr int types[] = {VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,     VTK_UNSIGNED_SHORT,
                             VTK_INT,         VTK_UNSIGNED_INT,  VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
                             VTK_FLOAT,       VTK_DOUBLE};
    return types[std::size_t(type)];
}

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
    : source_(std::move(source)), path_(path), use_(use)
{
    for (const PartArray& array : source_->arrays())
        arrays_.push_back({array.name, array.onPoints, array.components, vtkTypeOf(array.type)});
}

std::vector<std::size_t> PartBlocks::chosen() const
{
    return chosenParts(source_->parts(), wanted_, use_, path_);
}

void PartBlocks::keepParts(std::vector<std::string> wanted)
{
    wanted_ = std::move(wanted);
    const std::string usual = source_->usualVectors(chosen());
    for (ArrayInfo& array : arrays_) array.activeVectors = !usual.empty() && array.name == usual;
}

vtkSmartPointer<vtkDataObject> PartBlocks::readPieces(const std::vector<ArrayInfo>& kept, const PieceRun& run) const
{
    source_->keepPieces(run);
    const auto blocks = read(kept);
    return vtkMultiBlockDataSet::SafeDownCast(blocks)->GetBlock(0);
}

vtkSmartPointer<vtkDataObject> PartBlocks::read(const std::vector<ArrayInfo>& kept) const
{
    std::vector<PartArray> arrays;
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < source_->arrays().size(); ++i) {
        const PartArray& array = source_->arrays()[i];
        if (std::none_of(kept.begin(), kept.end(), [&](const ArrayInfo& each) {
                return each.name == array.name && each.onPoints == array.onPoints;
            }))
            continue;
        arrays.push_back(array);
        wanted.push_back(i);
    }
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    const auto add = [&](PartMesh mesh, const PartInfo& part) {
        const unsigned number = blocks->GetNumberOfBlocks();
        blocks->SetBlock(number,
                         dataSetOf(std::move(mesh), part.dimension, arrays, fmt::format("{}: '{}'", path_, part.name)));
        blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), part.name.c_str());
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
