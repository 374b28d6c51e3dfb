#include "reader/vtk/modules/ensight_reader.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArraySelection.h>
#include <vtkGenericEnSightReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkRemoveUnusedPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "aeolic/error.h"
#include "data/part_choice.h"
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
    EnSight6Case(const std::string& path, FileUse use, std::optional<double> time) : path_(path), use_(use)
    {
        reader_->SetCaseFileName(path.c_str());
        run([&] { reader_->UpdateInformation(); });
        const vtkInformation& info = *reader_->GetOutputInformation(0);
        auto* const key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
        if (const double* steps = const_cast<vtkInformation&>(info).Get(key))
            times_.assign(steps, steps + const_cast<vtkInformation&>(info).Length(key));
        if (!times_.empty()) time_ = time.value_or(times_.front());
        readAll();
    }

    const std::vector<ArrayInfo>& arrays() const override { return arrays_; }
    std::vector<double> times() const override { return times_; }
    const std::vector<PartInfo>& parts() const override { return parts_; }
    void keepParts(std::vector<std::string> wanted) override { wanted_ = std::move(wanted); }

    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) const override
    {
        auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        for (const std::size_t part : chosenParts(parts_, wanted_, use_, path_)) {
            const auto block = vtkSmartPointer<vtkDataSet>::Take(blocks_[part]->NewInstance());
            block->ShallowCopy(blocks_[part]);
            unifyArrays(*block, kept);
            const unsigned number = blocks->GetNumberOfBlocks();
            blocks->SetBlock(number, block);
            blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), parts_[part].name.c_str());
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

    /// Which parts there are, and of which kind, is known when they have been read.
    void readAll()
    {
        if (time_) reader_->GetOutputInformation(0)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), *time_);
        run([&] { reader_->Update(); });
        auto* const all = vtkMultiBlockDataSet::SafeDownCast(reader_->GetOutputDataObject(0));
        for (unsigned i = 0; all && i < all->GetNumberOfBlocks(); ++i) {
            vtkSmartPointer<vtkDataSet> block = vtkDataSet::SafeDownCast(all->GetBlock(i));
            if (!block || block->GetNumberOfCells() == 0) continue;
            const int dimension = dimensionOf(*block);
            if (dimension < 2) continue;
            if (vtkUnstructuredGrid::SafeDownCast(block)) {  // EnSight 6 has one list of points for all parts.
                vtkNew<vtkRemoveUnusedPoints> used;
                used->SetGenerateOriginalPointIds(false);
                used->SetInputData(block);
                run([&] { used->Update(); });
                block = used->GetOutput();
            }
            const vtkInformation* const info = all->HasMetaData(i) ? all->GetMetaData(i) : nullptr;
            const char* const name =
                info ? const_cast<vtkInformation*>(info)->Get(vtkCompositeDataSet::NAME()) : nullptr;
            parts_.push_back({name && *name ? name : fmt::format("part {}", i + 1),
                              dimension == 3 ? "volume" : "faces",
                              {},
                              dimension});
            for (const ArrayInfo& array : arraysOf(*block))
                if (std::none_of(arrays_.begin(), arrays_.end(), [&](const ArrayInfo& each) {
                        return each.name == array.name && each.onPoints == array.onPoints;
                    }))
                    arrays_.push_back(array);
            blocks_.push_back(block);
        }
        if (blocks_.empty()) throw InputError(path_, "it has no part of faces or cells", "one");
    }

    std::string path_;
    FileUse use_;
    vtkNew<vtkGenericEnSightReader> reader_;
    std::vector<double> times_;
    std::optional<double> time_;
    std::vector<PartInfo> parts_;
    std::vector<vtkSmartPointer<vtkDataSet>> blocks_;  // Of each.
    std::vector<ArrayInfo> arrays_;
    std::vector<std::string> wanted_;
};

}  // namespace

std::unique_ptr<OwnReader> openEnSight6(const std::string& path, FileUse use, std::optional<double> time)
{
    return std::make_unique<EnSight6Case>(path, use, time);
}

}  // namespace aeolic
