/// The check of NRRD headers: what it lets pass, VTK's reader gets.
#include <sstream>

#include "aeolic/error.h"
#include "memory_file.h"
#include "reader/vtk/checks/nrrd_header.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
    try {
        const aeolic::NrrdHeader header = aeolic::readNrrdHeader(file, "a.nhdr");
        if (header.valueCount() == 0 || header.valueCount() > std::uint64_t{1} << 60 || header.valueBytes == 0 ||
            header.headerBytes > size)
            __builtin_trap();
    } catch (const aeolic::InputError& error) {
        aeolic::fuzz::requireOneLine(error.what());
    }
    return 0;
}
