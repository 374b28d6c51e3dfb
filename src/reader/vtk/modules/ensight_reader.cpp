#include "reader/vtk/format_readers.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArraySelection.h>
#include <vtkGenericEnSightReader.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkRemoveUnusedPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "aeolic/error.h"
#include "data/vtk/messages.h"
#include "reader/vtk/block_arrays.h"

namespace aeolic {
namespace {

/// The highest dimension of the cells.
int dimensionOf(vtkDataSet& data)
{
    int dimension = 0;
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells() && dimension < 3; ++cell)
        dimension = std::max(dimension, data.GetCell(cell)->GetCellDimension());
    return dimension;
}

class EnSight6Case : public OwnReader {
public:
    EnSight6Case(const std::string& path, FileUse use, std::optional<double> time) : OwnReader(path, use)
    {
        reader_->SetCaseFileName(path.c_str());
        run([&] { reader_->UpdateInformation(); });
        vtkInformation* const info = reader_->GetOutputInformation(0);
        vtkInformationDoubleVectorKey* const key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
        if (const double* steps = info->Get(key)) times_.assign(steps, steps + info->Length(key));
        if (!times_.empty())
            info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), time.value_or(times_.front()));
    }

    const std::vector<ArrayInfo>& arrays() override { return step().arrays; }
    const std::vector<PartInfo>& parts() override { return step().parts; }

    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) override
    {
        auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        for (const std::size_t part : chosen()) {
            const auto block = vtkSmartPointer<vtkDataSet>::Take(step().blocks[part]->NewInstance());
            block->ShallowCopy(step().blocks[part]);
            unifyArrays(*block, kept);
            addBlock(*blocks, block, step().parts[part].name);
        }
        return blocks;
    }

private:
    template <class Run>
    void run(const Run& run) const
    {
        const VtkMessages messages;
        run();
        if (messages.failed())
            throw InputError(path_, "it cannot be read (" + messages.firstError() + ")", "a complete, undamaged case");
    }

    struct Step {
        std::vector<PartInfo> parts;
        std::vector<vtkSmartPointer<vtkDataSet>> blocks;  // The data of each part.
        std::vector<ArrayInfo> arrays;
    };

    /// All of the step. Which parts there are, and of which kind, is known when they have been read.
    const Step& step()
    {
        if (step_) return *step_;
        run([&] { reader_->Update(); });
        Step read;
        auto* const all = vtkMultiBlockDataSet::SafeDownCast(reader_->GetOutputDataObject(0));
        for (unsigned i = 0; all && i < all->GetNumberOfBlocks(); ++i) {
            vtkSmartPointer<vtkDataSet> block = vtkDataSet::SafeDownCast(all->GetBlock(i));
            const int dimension = block ? dimensionOf(*block) : 0;
            if (dimension < 2) continue;
            if (vtkUnstructuredGrid::SafeDownCast(block)) block = withoutUnusedPoints(*block);
            const char* const name =
                all->HasMetaData(i) ? all->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
            read.parts.push_back({name && *name ? name : fmt::format("part {}", i + 1),
                                  dimension == 3 ? "volume" : "faces",
                                  {},
                                  dimension});
            read.blocks.push_back(block);
            addOthers(read.arrays, arraysOf(*block));
        }
        if (read.blocks.empty()) throw InputError(path_, "it has no part of faces or cells", "one");
        step_ = std::move(read);
        return *step_;
    }

    /// EnSight 6 has one list of points for all parts.
    vtkSmartPointer<vtkDataSet> withoutUnusedPoints(vtkDataSet& block) const
    {
        vtkNew<vtkRemoveUnusedPoints> used;
        used->SetGenerateOriginalPointIds(false);
        used->SetInputData(&block);
        run([&] { used->Update(); });
        return used->GetOutput();
    }

    vtkNew<vtkGenericEnSightReader> reader_;
    std::optional<Step> step_;  // Once it was asked for.
};

}  // namespace

std::unique_ptr<OwnReader> openEnSight6(const std::string& path, FileUse use, std::optional<double> time)
{
    return std::make_unique<EnSight6Case>(path, use, time);
}

}  // namespace aeolic
