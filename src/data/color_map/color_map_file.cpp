#include "data/color_map/color_map_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "aeolic/error.h"
#include "data/reading/file_questions.h"

namespace aeolic {
namespace {

constexpr std::size_t largestFileBytes = std::size_t{64} << 20;  // Over a million points.

std::string fileText(const std::string& path)
{
    const std::string expected = "a colour map (.json, .xml, .csv)";
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw InputError(path, "found a folder", expected);
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
        throw InputError(path, "found a device", expected);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path, std::string("cannot be opened (") + std::strerror(errno) + ")", expected);
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (bytes > largestFileBytes) throw InputError(path, "found more than 64 MiB", expected);
    std::string text(std::size_t(bytes), '\0');
    file.read(text.data(), std::streamsize(text.size()));
    if (file.bad()) throw InputError(path, "cannot be read", expected);
    text.resize(std::size_t(file.gcount()));
    return text;
}

}  // namespace

ColorMap loadColorMap(const std::string& nameOrPath)
{
    if (!isColorMapFile(nameOrPath)) return {colorMap(nameOrPath), {}, {}, {}};
    const std::string text = fileText(nameOrPath);
    const char last = nameOrPath.back();  // .json, .xml, .csv
    return colorMapOf(last == 'n' || last == 'N'   ? colorPointsFromJson(text, nameOrPath)
                      : last == 'l' || last == 'L' ? colorPointsFromXml(text, nameOrPath)
                                                   : colorPointsFromCsv(text, nameOrPath),
                      nameOrPath);
}

}  // namespace aeolic
