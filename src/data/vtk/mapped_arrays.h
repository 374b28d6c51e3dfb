#pragma once

#include <vtkDataArray.h>

#include <memory>

#include "data/reading/shared_memory.h"

namespace aeolic {

/// Makes mapped memory the values of an array, without a copy. The array keeps the memory. Throws std::bad_alloc.
void setMapped(vtkDataArray& array, std::shared_ptr<SharedMemory> memory, vtkIdType values);

/// Whether the values are memory that a reader wrote: it lies on small pages, on which scattered reads are slow.
bool isMapped(vtkDataArray& array);

}  // namespace aeolic
