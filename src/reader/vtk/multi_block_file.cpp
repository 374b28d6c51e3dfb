#include "reader/vtk/format_readers.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "aeolic/error.h"
#include "base/text.h"
#include "reader/vtk/block_arrays.h"
#include "reader/vtk/data_file.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {
namespace {

/// What a file of blocks can be: blocks in a tree, or uniform grids in levels, of which finer ones lie over coarser
/// ones.
constexpr const char* kTrees[] = {"vtkMultiBlockDataSet", "vtkOverlappingAMR", "vtkNonOverlappingAMR",
                                  "vtkHierarchicalBoxDataSet"};
constexpr int kNoLevel = -1;

constexpr int kDeepestFiles = 3;  // Files that name files that name files.

bool isMultiBlock(const std::string& path)
{
    const FileKind* kind = fileKindOf(path);
    return kind && kind->has(kHasBlocks);
}

/// What a file holds, by its ending.
PartInfo partOf(const std::string& name, const std::vector<std::string>& groups, const std::string& file)
{
    const FileKind* kind = fileKindOf(file);
    if (kind && !kind->holdsData()) kind = nullptr;
    return {name, kind ? kind->kind : "unknown", groups, kind && kind->use == FileUse::surface ? 2 : 3};
}

/// A block of a data set that is refined in levels.
struct LeveledBlock {
    vtkSmartPointer<vtkDataObject> data;
    int level = 0;
};

/// Middles of cells that lie so near to a block's border count as beside it, in widths of cells.
constexpr double kSlack = 1e-6;

vtkUnsignedCharArray& flagsOf(vtkImageData& grid)
{
    const char* const name = vtkDataSetAttributes::GhostArrayName();
    vtkCellData& cells = *grid.GetCellData();
    if (auto* flags = vtkUnsignedCharArray::SafeDownCast(cells.GetArray(name))) return *flags;
    vtkSmartPointer<vtkUnsignedCharArray> made = vtkSmartPointer<vtkUnsignedCharArray>::New();
    made->SetName(name);
    made->SetNumberOfValues(grid.GetNumberOfCells());
    made->FillValue(0);
    cells.AddArray(made);
    return *vtkUnsignedCharArray::SafeDownCast(cells.GetArray(name));
}

/// The cells along an axis whose middles lie within a range: [first, last).
std::array<int, 2> cellsWithin(vtkImageData& grid, int axis, double lo, double hi)
{
    const int cells = std::max(grid.GetDimensions()[axis] - 1, 1);
    const double width = grid.GetSpacing()[axis], first = grid.GetOrigin()[axis] + grid.GetExtent()[2 * axis] * width;
    if (grid.GetDimensions()[axis] < 2) return {0, 1};  // A flat grid.
    if (!(width > 0) || !std::isfinite(width) || !std::isfinite(first)) return {0, 0};
    const auto at = [&](double place) { return (place - first) / width - 0.5; };
    const double begin = std::ceil(at(lo) + kSlack), end = std::floor(at(hi) - kSlack) + 1;
    return {int(std::clamp(begin, 0.0, double(cells))), int(std::clamp(end, 0.0, double(cells)))};
}

void hideWithin(vtkImageData& grid, const double (&bounds)[6])
{
    std::array<std::array<int, 2>, 3> range{};
    for (int axis = 0; axis < 3; ++axis) {
        range[std::size_t(axis)] = cellsWithin(grid, axis, bounds[2 * axis], bounds[2 * axis + 1]);
        if (range[std::size_t(axis)][0] >= range[std::size_t(axis)][1]) return;
    }
    vtkUnsignedCharArray& flags = flagsOf(grid);
    const auto across = vtkIdType(std::max(grid.GetDimensions()[0] - 1, 1)),
               down = vtkIdType(std::max(grid.GetDimensions()[1] - 1, 1));
    for (int z = range[2][0]; z < range[2][1]; ++z)
        for (int y = range[1][0]; y < range[1][1]; ++y)
            for (int x = range[0][0]; x < range[0][1]; ++x) {
                const vtkIdType cell = (vtkIdType(z) * down + y) * across + x;
                flags.SetValue(cell, flags.GetValue(cell) | vtkDataSetAttributes::REFINEDCELL);
            }
}

/// Marks those cells of uniform grids whose middle lies in a block of a finer level: that one is drawn instead. Other
/// data stay as they are. Cost: O(cells), for blocks that overlap.
void hideRefined(const std::vector<LeveledBlock>& blocks)
{
    for (const LeveledBlock& coarse : blocks)
        for (const LeveledBlock& fine : blocks) {
            if (fine.level <= coarse.level) continue;
            auto* const grid = vtkImageData::SafeDownCast(coarse.data);
            auto* const over = vtkImageData::SafeDownCast(fine.data);
            if (!grid || !over || over->GetNumberOfCells() == 0) continue;
            double bounds[6];
            over->GetBounds(bounds);
            hideWithin(*grid, bounds);
        }
}

class MultiBlockFile : public OwnReader {
public:
    MultiBlockFile(const std::string& path, FileUse use) : OwnReader(path, use) { findBlocks(path, 1, "", {}); }

    const std::vector<ArrayInfo>& arrays() override
    {
        if (readers_.empty()) open();
        return arrays_;
    }

    void keepParts(const std::vector<std::string>& wanted) override
    {
        OwnReader::keepParts(wanted);
        readers_.clear();
    }

    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) override
    {
        if (readers_.empty()) open();
        auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
        std::vector<LeveledBlock> leveled;
        for (const auto& [part, reader] : readers_) {
            reader->keepOnly(kept);
            const auto data = reader->read({}, "reading a block");
            if (auto* set = vtkDataSet::SafeDownCast(data)) unifyArrays(*set, kept);
            leveled.push_back({data, files_[part].level});
            addBlock(*blocks, data, parts_[part].name);
        }
        if (leveled.size() > 1 && leveled.back().level != kNoLevel) hideRefined(leveled);
        return blocks;
    }

private:
    void findBlocks(const std::string& file, int depth, const std::string& above,
                    const std::vector<std::string>& groups)
    {
        if (depth > kDeepestFiles)
            throw InputError(file, "files name files too deeply", fmt::format("{} levels", kDeepestFiles));
        const auto root = parseXml(file, "a VTK XML file");
        const std::string type = attributeOf(*root, "type");
        const auto primaries = childrenOf(*root, type);
        const bool isKnown = std::ranges::find(kTrees, type) != std::end(kTrees);
        if (!isKnown || primaries.size() != 1)
            throw InputError(file, fmt::format("it has {} elements '{:.40}'", primaries.size(), type),
                             "one vtkMultiBlockDataSet, or one AMR data set");
        findIn(*primaries.front(), {file, depth, kNoLevel}, above, groups, true);
    }

    struct Walk {
        const std::string& file;
        int depth;
        int level;  ///< Of a data set in levels; else kNoLevel.
    };

    /// `named`: the blocks have names of their own behind `above`; pieces have that of what they are pieces of.
    void findIn(vtkXMLDataElement& parent, const Walk& walk, const std::string& above,
                const std::vector<std::string>& groups, bool named)
    {
        std::vector<std::pair<int, vtkXMLDataElement*>> children;
        for (int i = 0; i < parent.GetNumberOfNestedElements(); ++i) {
            vtkXMLDataElement& child = *parent.GetNestedElement(i);
            int index = 0;
            if (child.GetAttribute("index") && (!child.GetScalarAttribute("index", index) || index < 0))
                throw InputError(walk.file, fmt::format("a block of index '{:.40}'", attributeOf(child, "index")),
                                 "a number from 0");
            children.emplace_back(index, &child);
        }
        std::ranges::stable_sort(children, [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [index, child] : children) {
            const std::string kind = child->GetName(), level = attributeOf(*child, "level");
            const std::string own = level.empty() ? attributeOf(*child, "name") : "level" + level;
            const std::string name = named ? above + (own.empty() ? std::to_string(index) : own) : above;
            Walk inner = walk;
            if (!level.empty() && !child->GetScalarAttribute("level", inner.level))
                throw InputError(walk.file, fmt::format("a block of level '{:.40}'", level), "a number from 0");
            const std::string file = attributeOf(*child, "file");
            std::vector<std::string> within = groups;
            if (named) within.push_back(name);
            if (kind == "Piece") {
                findIn(*child, walk, name, groups, false);
            } else if (kind == "Block") {
                findIn(*child, inner, name + "/", within, true);
            } else if (kind == "DataSet" && !file.empty()) {
                addFile(walk, name, groups, within, (std::filesystem::path(walk.file).parent_path() / file).string());
            }
        }
    }

    void addFile(const Walk& walk, const std::string& name, const std::vector<std::string>& groups,
                 const std::vector<std::string>& within, const std::string& file)
    {
        std::error_code error;
        if (!std::filesystem::is_regular_file(file, error))
            throw InputError(walk.file, "its piece " + file + " is not there", "a file for each piece");
        if (isMultiBlock(file)) {
            findBlocks(file, walk.depth + 1, name + "/", within);
            return;
        }
        parts_.push_back(partOf(name, groups, file));
        files_.push_back({file, walk.level});
    }

    /// The files of the blocks that are wanted, and all arrays that any of them has.
    void open()
    {
        arrays_.clear();
        for (const std::size_t part : chosen()) {
            const std::string extension = lowerExtension(files_[part].name);
            if (!extension.starts_with(".vt") && !extension.starts_with(".pvt"))
                throw InputError(path_,
                                 fmt::format("its block '{}' is the file {}", parts_[part].name, files_[part].name),
                                 "VTK XML files");
            auto reader = std::make_unique<DataFile>(files_[part].name, FileUse::any);
            addOthers(arrays_, reader->announcedArrays());
            readers_.emplace_back(part, std::move(reader));
        }
    }

    struct BlockFile {
        std::string name;
        int level;  // Or kNoLevel.
    };
    std::vector<BlockFile> files_;                                            // Of each part.
    std::vector<std::pair<std::size_t, std::unique_ptr<DataFile>>> readers_;  // Of the parts that are wanted.
};

}  // namespace

std::unique_ptr<OwnReader> openMultiBlock(const std::string& path, FileUse use, std::optional<double>)
{
    return std::make_unique<MultiBlockFile>(path, use);
}

}  // namespace aeolic
