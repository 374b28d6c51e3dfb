/// Files that name the steps of a series: JSON (.series) behind a 'J', XML (.pvd) behind anything else.
#include "aeolic/error.h"
#include "memory_file.h"
#include "reader/lists/series_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    const aeolic::fuzz::MemoryFile file(data + 1, size - 1);
    try {
        const auto entries = data[0] == 'J' ? aeolic::readSeriesFile(file.path()) : aeolic::readPvdFile(file.path());
        for (const auto& entry : entries)
            if (entry.file.empty()) __builtin_trap();
    } catch (const aeolic::InputError& error) {
        aeolic::fuzz::requireOneLine(error.what());
    }
    return 0;
}
