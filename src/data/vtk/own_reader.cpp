#include "data/vtk/own_reader.h"

#include "data/parts/open_parts.h"
#include "data/vtk/hdf/hdf_file.h"
#include "data/vtk/multi_block_file.h"
#include "data/vtk/part_blocks.h"

namespace aeolic {

std::unique_ptr<OwnReader> openOwnReader(const std::string& path, const std::string& extension, FileUse use,
                                         std::optional<double> time)
{
    if (auto parts = openPartSource(path, extension, time))
        return std::make_unique<PartBlocks>(std::move(parts), path, use);
    if (extension == ".vtkhdf" || extension == ".hdf") return openVtkHdf(path, use, time);
    if (extension == ".vtm" || extension == ".vtmb") return openMultiBlock(path, use);
    return nullptr;
}

}  // namespace aeolic
