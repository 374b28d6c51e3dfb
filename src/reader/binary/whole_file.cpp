#include "reader/binary/whole_file.h"

#include <fstream>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/named_file.h"

namespace aeolic {

std::string wholeFile(const std::string& path)
{
    const std::uint64_t bytes = checkReadableFile(path);
    requireMemory(path, "reading it", 2 * bytes);
    std::string text(bytes, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file.read(text.data(), std::streamsize(bytes)))
        throw InputError(path, "it has become shorter while it was read", "a file that can be read");
    return text;
}

}  // namespace aeolic
