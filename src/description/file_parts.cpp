#include "description/file_parts.h"

#include <filesystem>
#include <string_view>

#include "aeolic/error.h"

namespace aeolic {

FileAndParts splitParts(const std::string& spec)
{
    std::error_code error;
    const std::size_t colon = spec.rfind(':');
    if (colon == std::string::npos || colon == 0 || std::filesystem::exists(spec, error)) return {spec, {}};
    FileAndParts split{spec.substr(0, colon), {}};
    std::string_view rest = std::string_view(spec).substr(colon + 1);
    for (;;) {
        const std::size_t comma = rest.find(',');
        if (comma != 0 && !rest.empty()) split.parts.emplace_back(rest.substr(0, comma));
        if (comma == std::string_view::npos) break;
        rest.remove_prefix(comma + 1);
    }
    if (split.parts.empty())
        throw InputError("surface '" + spec + "'", "no part is named behind ':'", "names, groups or patterns with *");
    return split;
}

}  // namespace aeolic
