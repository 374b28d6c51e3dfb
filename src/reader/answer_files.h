#pragma once

#include <map>
#include <vector>

#include "data/reading/owned_file.h"
#include "data/vtk/data_message.h"

namespace aeolic {

/// The memory of one answer, as sealed files: that of the arrays themselves, or a copy where it is no file.
class AnswerFiles : public AnswerMemory {
public:
    /// Throws std::bad_alloc.
    std::uint32_t place(const void* bytes, std::size_t count) override;

    std::vector<int> descriptors() const;

private:
    std::vector<OwnedFile> files_;
    std::map<std::pair<const void*, std::size_t>, std::uint32_t> placed_;  // Data sets may have arrays in common.
};

}  // namespace aeolic
