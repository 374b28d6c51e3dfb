#include "description/file_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/text.h"

namespace aeolic {
namespace {

bool fits(const FileKind& row, FileUse use)
{
    return row.holdsData() && (use == FileUse::any || row.use == FileUse::any || row.use == use);
}

/// The first of some kinds that has an ending which fits; null where there is none.
template <class Kind, std::size_t N, class Fits>
const Kind* kindWith(const Kind (&kinds)[N], const Fits& fits)
{
    const auto* const found = std::ranges::find_if(
        kinds, [&](const Kind& kind) { return std::ranges::any_of(splitText(kind.endings, ' '), fits); });
    return found == std::end(kinds) ? nullptr : found;
}

}  // namespace

const FileKind* fileKindOf(std::string_view path)
{
    std::string extension = lowerExtension(std::string(path));
    // What Exodus writes after its mesh has changed: "can.e", "can.e-s002" …
    const std::size_t dash = extension.rfind("-s");
    if (dash != std::string::npos && dash + 2 < extension.size() &&
        extension.find_first_not_of("0123456789", dash + 2) == std::string::npos)
        extension.resize(dash);
    return kindWith(fileKinds, [&](std::string_view ending) { return ending == extension; });
}

const UnreadKind* unreadKindOf(std::string_view path)
{
    const std::string name = lowerCase(std::string(path));
    return kindWith(unreadKinds, [&](std::string_view ending) { return name.ends_with(ending); });
}

std::string fileKindsText(FileUse use)
{
    std::string text;
    bool folder = false;
    for (const FileKind& row : fileKinds) {
        if (!fits(row, use)) continue;
        folder = folder || row.has(kIsFolder);
        text += (text.empty() ? "" : " ") + std::string(row.endings);
    }
    return folder ? text + ", or an OpenFOAM case's folder" : text;
}

std::string withFileKinds(std::string_view text)
{
    return fmt::format(fmt::runtime(text), fmt::arg("surfaces", fileKindsText(FileUse::surface)),
                       fmt::arg("fields", fileKindsText(FileUse::field)));
}

}  // namespace aeolic
