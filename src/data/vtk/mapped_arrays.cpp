#include "data/vtk/mapped_arrays.h"

#include <map>
#include <mutex>

namespace aeolic {
namespace {

/// VTK hands nothing but an array's address to the function that frees it.
struct MappedArrays {
    std::mutex mutex;
    std::multimap<void*, std::shared_ptr<SharedMemory>> memory;  // Several arrays may have the same.
};

MappedArrays& mapped()
{
    static auto* all = new MappedArrays;  // Arrays may outlive everything else.
    return *all;
}

void freeMapped(void* address)
{
    std::shared_ptr<SharedMemory> last;
    MappedArrays& all = mapped();
    const std::lock_guard lock(all.mutex);
    const auto found = all.memory.find(address);
    if (found == all.memory.end()) return;
    last = std::move(found->second);
    all.memory.erase(found);
}

}  // namespace

void setMapped(vtkDataArray& array, std::shared_ptr<SharedMemory> memory, vtkIdType values)
{
    void* const address = memory->data();
    memory->expectUse(std::size_t(values) * std::size_t(array.GetDataTypeSize()));
    {
        const std::lock_guard lock(mapped().mutex);
        mapped().memory.emplace(address, std::move(memory));
    }
    array.SetVoidArray(address, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
    array.SetArrayFreeFunction(freeMapped);
}

bool isMapped(vtkDataArray& array)
{
    const std::lock_guard lock(mapped().mutex);
    return array.GetNumberOfValues() > 0 && mapped().memory.contains(array.GetVoidPointer(0));
}

}  // namespace aeolic
