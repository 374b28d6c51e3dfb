#pragma once

#include <vtkDataArray.h>

#include "base/large_memory.h"

namespace aeolic {

/// One of VTK's XML readers, with large arrays on huge pages where the system has them: most of its time VTK waits for
/// the pages that it reads into.
template <class Reader>
class LargeArrays : public Reader {
public:
    static LargeArrays* New()
    {
        auto* reader = new LargeArrays;
        reader->InitializeObjectBase();
        return reader;
    }

protected:
    LargeArrays() = default;

    /// VTK has allocated the array, but not written into it yet.
    int ReadArrayValues(vtkXMLDataElement* element, vtkIdType index, vtkAbstractArray* array, vtkIdType start,
                        vtkIdType count, typename Reader::FieldType type) override
    {
        if (auto* numbers = vtkDataArray::SafeDownCast(array); numbers && numbers->HasStandardMemoryLayout())
            wishForHugePages(numbers->GetVoidPointer(0),
                             std::size_t(numbers->GetNumberOfValues()) * std::size_t(numbers->GetDataTypeSize()));
        return Reader::ReadArrayValues(element, index, array, start, count, type);
    }
};

}  // namespace aeolic
