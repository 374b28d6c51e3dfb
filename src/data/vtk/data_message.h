#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/byte_message.h"
#include "data/reading/shared_memory.h"

namespace aeolic {

/// What a data object is, in a message.
enum class DataForm : std::uint8_t { none, blocks, polygons, image, rectilinear, structured, unstructured };

/// In the place of a memory's number: an array's values follow in the message.
inline constexpr std::uint32_t kArrayInMessage = 0xffffffff;

/// In the reader: where the large arrays of an answer lie.
class AnswerMemory {
public:
    virtual ~AnswerMemory() = default;

    /// The number of the memory that begins with these bytes, and may be longer, among those that go along with the
    /// answer.
    virtual std::uint32_t place(const void* bytes, std::size_t count) = 0;
};

/// Data sets as a message between the reader and its caller: image data, rectilinear, structured and unstructured
/// grids, polygons, and multi-block data sets of them, with all arrays of numbers, and which of these are active. Small
/// arrays stand in the message.
void addData(ByteWriter& message, vtkDataObject* data, AnswerMemory& memory);

/// The data sets of a message that addData() wrote, in the memory that came along. Nothing in the message is believed:
/// throws InputError, which begins with `path`, for parts that do not fit together. The points of cells are
/// left to requireSoundData().
vtkSmartPointer<vtkDataObject> readData(ByteReader& message, const std::vector<std::shared_ptr<SharedMemory>>& memory,
                                        const std::string& path);

}  // namespace aeolic
