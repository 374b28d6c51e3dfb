#include "description/colormap.h"

#include <charconv>
#include <cstddef>
#include <string>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "description/file_kinds.h"

namespace aeolic {

namespace {

struct NamedTable {
    std::string_view name;
    std::string_view hex;  // 256 * RRGGBB
};

constexpr NamedTable tables[] = {
#include "description/colormap_data.inc"
};
constexpr std::size_t tableCount = std::size(tables);

constexpr unsigned hexDigit(char c)
{
    return c <= '9' ? unsigned(c - '0') : unsigned(c - 'a') + 10;
}

constexpr ColorTable decoded(std::string_view hex)
{
    ColorTable table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            table[i][c] = std::uint8_t(16 * hexDigit(hex[6 * i + 2 * c]) + hexDigit(hex[6 * i + 2 * c + 1]));
    return table;
}

constexpr bool allComplete()
{
    for (const NamedTable& table : tables)
        if (table.hex.size() != 6 * std::tuple_size_v<ColorTable>) return false;
    return true;
}
static_assert(allComplete());

constexpr auto decodedTables = [] {
    std::array<ColorTable, tableCount> all{};
    for (std::size_t i = 0; i < tableCount; ++i) all[i] = decoded(tables[i].hex);
    return all;
}();

constexpr auto mapNames = [] {
    std::array<std::string_view, tableCount> all{};
    for (std::size_t i = 0; i < tableCount; ++i) all[i] = tables[i].name;
    return all;
}();

}  // namespace

const ColorTable& colorMap(std::string_view name)
{
    std::string expected;
    for (std::size_t i = 0; i < tableCount; ++i) {
        if (mapNames[i] == name) return decodedTables[i];
        expected += (i ? ", " : "one of ") + std::string(mapNames[i]);
    }
    throw InputError("colour map", "found '" + std::string(name) + "'", expected + didYouMean(name, mapNames));
}

std::span<const std::string_view> colorMapNames()
{
    return mapNames;
}

bool isColorMapFile(std::string_view name)
{
    const FileKind* kind = fileKindOf(name);
    return kind && kind->use == FileUse::colorMap;
}

Color colorOf(std::string_view rrggbb)
{
    unsigned long rgb = 0;
    std::from_chars(rrggbb.data(), rrggbb.data() + rrggbb.size(), rgb, 16);
    return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb)};
}

}  // namespace aeolic
