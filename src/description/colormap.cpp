#include "description/colormap.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

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

static_assert(std::ranges::all_of(tables, [](const NamedTable& table) {
    return table.hex.size() == 6 * std::tuple_size_v<ColorTable>;
}));

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
    const auto found = std::ranges::find(mapNames, name);
    if (found != mapNames.end()) return decodedTables[std::size_t(found - mapNames.begin())];
    throw InputError("colour map", fmt::format("found '{}'", name),
                     fmt::format("one of {}{}", fmt::join(mapNames, ", "), didYouMean(name, mapNames)));
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
