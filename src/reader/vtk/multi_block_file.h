#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/vtk/own_reader.h"

namespace aeolic {

/// A VTK XML multi-block file (.vtm, .vtmb): a tree of names over files, some of which may be such files themselves.
/// Only the files of blocks that are wanted are opened. A block that lacks an array which others have gets one of NaN.
/// It has no times. Throws InputError.
std::unique_ptr<OwnReader> openMultiBlock(const std::string& path, FileUse use, std::optional<double> time);

}  // namespace aeolic
