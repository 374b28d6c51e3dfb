#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reader/netcdf/netcdf_file.h"
#include "reader/parts/cell_faces.h"

namespace aeolic {

/// The elements of one kind in an Exodus file.
struct ExodusBlock {
    std::string name, type;  ///< "fluid", "HEX8"
    std::vector<std::string> groups;
    std::size_t number = 0;          ///< In the names of variables, from 1.
    std::size_t count = 0;           ///< Of its elements.
    std::int64_t first = 1;          ///< The number of its first element in the file.
    std::optional<CellShape> shape;  ///< None: its elements are no cells (points, lines, unknown ones).
};

/// Sides of elements.
struct ExodusSideSet {
    std::string name;
    std::vector<std::string> groups;
    std::size_t number = 0;
};

/// The blocks of a file, and the shapes of their elements. Throws InputError.
std::vector<ExodusBlock> readExodusBlocks(const NetcdfFile& file);
std::vector<ExodusSideSet> readExodusSideSets(const NetcdfFile& file);

/// A block's cells, their corners from 0 and below `points`.
PartCells readExodusCells(const NetcdfFile& file, const ExodusBlock& block, std::size_t points);

/// The faces of a side set: which cell of which block each belongs to, and its place in the file's list. Sides that are
/// no faces are left out.
struct ExodusSides {
    FaceList faces;
    std::vector<std::size_t> blocks, cells, places;
};
ExodusSides readExodusSides(const NetcdfFile& file, const ExodusSideSet& set, const std::vector<ExodusBlock>& blocks,
                            std::size_t points);

}  // namespace aeolic
