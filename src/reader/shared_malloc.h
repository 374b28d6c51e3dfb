#pragma once

#include <cstddef>

#include "data/reading/owned_file.h"

namespace aeolic {

/// In this program every large piece of memory that malloc() hands out, to whatever library, is a memory file. So what
/// a library has read goes to the caller as it lies there: nothing is copied, and nothing is in memory twice.
///
/// The memory file that begins at `memory` and has `bytes` or more, sealed, so that nobody can change it. This process
/// can still read it; its later writes stay in this process. None where the memory is no such file, since it is small
/// or a sanitizer has replaced malloc(), and where it was sealed before.
OwnedFile sealedFileOf(const void* memory, std::size_t bytes);

}  // namespace aeolic
