#include "render/colormap.h"

#include <cstddef>

#include "aeolic/error.h"

namespace aeolic {

namespace {

struct NamedTable {
    std::string_view name;
    std::string_view hex;  // 256 * RRGGBB
};

constexpr NamedTable tables[] = {
#include "render/colormap_data.inc"
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

}  // namespace

const ColorTable& colorMap(std::string_view name)
{
    std::string names;
    for (std::size_t i = 0; i < tableCount; ++i) {
        if (tables[i].name == name) return decodedTables[i];
        names += (i ? ", " : "") + std::string(tables[i].name);
    }
    throw InputError("colour map", "found '" + std::string(name) + "'", "one of " + names);
}

std::vector<std::string> colorMapNames()
{
    std::vector<std::string> names;
    for (const NamedTable& table : tables) names.emplace_back(table.name);
    return names;
}

}  // namespace aeolic
