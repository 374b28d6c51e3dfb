#include "description/file_kinds.h"
#include "base/text.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace aeolic {
namespace {

bool fits(const FileKind& row, FileUse use)
{
    return row.holdsData() && (use == FileUse::any || row.use == FileUse::any || row.use == use);
}

void replaceAll(std::string& text, std::string_view mark, const std::string& by)
{
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + by.size()))
        text.replace(at, mark.size(), by);
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
    for (const FileKind& row : fileKinds) {
        bool found = false;
        forEachEnding(row, [&](std::string_view ending) { found = found || ending == extension; });
        if (found) return &row;
    }
    return nullptr;
}

const UnreadKind* unreadKindOf(std::string_view path)
{
    const std::string name = lowerCase(std::string(path));
    for (const UnreadKind& row : unreadKinds) {
        bool found = false;
        forEachEnding(row, [&](std::string_view ending) { found = found || name.ends_with(ending); });
        if (found) return &row;
    }
    return nullptr;
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
        if (!row.holdsData()) continue;
        const char* use = row.use == FileUse::surface ? "`--surface`"
                          : row.use == FileUse::field ? "`--field`"
                                                      : "`--surface`, `--field`";
        const auto add = [&](const std::string& ending, const char* format) {
            text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", ending, format, use, row.holds,
                                row.has(kHasParts) ? "yes" : "", row.has(kHasTimes) ? "yes" : "", row.reader);
        };
        const char* format = row.format;
        if (row.has(kIsFolder)) add("its folder", std::exchange(format, "the same, by a file in the folder"));
        forEachEnding(row, [&](std::string_view ending) {
            add(fmt::format("`{}`", ending), format);
            format = "the same";
        });
    }
    return text;
}

}  // namespace aeolic
