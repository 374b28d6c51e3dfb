#include "data/vtk/surface/blocks.h"

#include <vtkDataSetSurfaceFilter.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>

#include "data/part_choice.h"

namespace aeolic {
namespace {

void addBlocks(vtkMultiBlockDataSet& blocks, const std::string& above, const std::vector<std::string>& groups,
               std::vector<Block>& all)
{
    for (unsigned i = 0; i < blocks.GetNumberOfBlocks(); ++i) {
        vtkDataObject* block = blocks.GetBlock(i);
        if (!block) continue;
        const bool named = blocks.HasMetaData(i) && blocks.GetMetaData(i)->Has(vtkCompositeDataSet::NAME());
        const std::string name =
            above + (named ? blocks.GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : std::to_string(i));
        if (auto* tree = vtkMultiBlockDataSet::SafeDownCast(block)) {
            std::vector<std::string> within = groups;
            within.push_back(name);
            addBlocks(*tree, name + "/", within, all);
        } else if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(block)) {
            for (unsigned piece = 0; piece < pieces->GetNumberOfPartitions(); ++piece)
                if (vtkDataObject* data = pieces->GetPartitionAsDataObject(piece)) all.push_back({name, groups, data});
        } else {
            all.push_back({name, groups, block});
        }
    }
}

}  // namespace

std::vector<Block> blocksOf(vtkMultiBlockDataSet& blocks)
{
    std::vector<Block> all;
    addBlocks(blocks, "", {}, all);
    return all;
}

std::vector<Block> chooseBlocks(const std::vector<Block>& blocks, const std::vector<std::string>& wanted,
                                const std::string& path)
{
    if (wanted.empty()) return blocks;
    std::vector<PartName> names;
    for (const Block& block : blocks) names.push_back({block.name, block.groups});
    std::vector<Block> chosen;
    for (const std::size_t i : chooseParts(names, wanted, path)) chosen.push_back(blocks[i]);
    return chosen;
}

vtkSmartPointer<vtkPolyData> outerSurface(vtkDataSet& cells)
{
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputData(&cells);
    filter->Update();
    return filter->GetOutput();
}

}  // namespace aeolic
