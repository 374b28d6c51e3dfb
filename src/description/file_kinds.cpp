#include "description/file_kinds.h"
#include "base/text.h"

#include <fmt/format.h>

#include <string_view>

namespace aeolic {
namespace {

bool fits(const FileKind& row, FileUse use)
{
    return use == FileUse::any || row.use == FileUse::any || row.use == use;
}

void replaceAll(std::string& text, std::string_view mark, const std::string& by)
{
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + by.size()))
        text.replace(at, mark.size(), by);
}

}  // namespace

const FileKind* fileKindOf(const std::string& path)
{
    const std::size_t slash = path.rfind('/'), dot = path.rfind('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return nullptr;
    const std::string extension = lowerCase(path.substr(dot));
    for (const FileKind& row : fileKinds)
        if (extension == row.extension) return &row;
    return nullptr;
}

std::string fileKindsText(FileUse use)
{
    std::string text;
    bool folder = false;
    for (const FileKind& row : fileKinds) {
        if (!fits(row, use)) continue;
        if (row.extension[0] == '\0')
            folder = true;
        else
            text += std::string(text.empty() ? "" : " ") + row.extension;
    }
    return folder ? text + ", or an OpenFOAM case's folder" : text;
}

std::string withFileKinds(std::string text)
{
    replaceAll(text, "{surfaces}", fileKindsText(FileUse::surface));
    replaceAll(text, "{fields}", fileKindsText(FileUse::field));
    return text;
}

std::string fileKindsTable()
{
    std::string text =
        "| ending | format | for | values on | parts | times in one | read by |\n|---|---|---|---|---|---|---|\n";
    for (const FileKind& row : fileKinds) {
        const std::string ending = row.extension[0] == '\0' ? "a folder" : fmt::format("`{}`", row.extension);
        const char* use = row.use == FileUse::surface ? "`--surface`"
                          : row.use == FileUse::field ? "`--field`"
                                                      : "`--surface`, `--field`";
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", ending, row.format, use, row.holds,
                            row.parts ? "yes" : "", row.times ? "yes" : "", row.reader);
    }
    return text;
}

}  // namespace aeolic
