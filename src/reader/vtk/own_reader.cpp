#include "reader/vtk/own_reader.h"

#include "reader/parts/open_parts.h"
#include "reader/vtk/modules/modules.h"
#include "reader/vtk/multi_block_file.h"
#include "reader/vtk/part_blocks.h"

namespace aeolic {

std::unique_ptr<OwnReader> openOwnReader(const std::string& path, const std::string& extension, FileUse use,
                                         std::optional<double> time)
{
    if (auto parts = openPartSource(path, extension, time))
        return std::make_unique<PartBlocks>(std::move(parts), path, use);
    if (extension == ".vtkhdf" || extension == ".hdf") return hdf5Module().openVtkHdf(path, use, time);
    if (extension == ".vtm" || extension == ".vtmb") return openMultiBlock(path, use);
    return nullptr;
}

}  // namespace aeolic
