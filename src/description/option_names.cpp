#include "description/option_names.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>

#include "description/option_table.h"
#include "description/scene_text.h"

namespace aeolic {
namespace {

constexpr std::string_view kDashes = "--", kListedSurface = "surfaces[";

std::string snakeCase(std::string_view key)
{
    std::string name;
    for (const char c : key) {
        const bool begins = std::isupper(static_cast<unsigned char>(c)) != 0;
        if (begins) name += '_';
        name += begins ? char(std::tolower(static_cast<unsigned char>(c))) : c;
    }
    return name;
}

bool isInWord(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
}

/// Whether the command line has an option of that name for scenes.
bool isOfScene(std::string_view name)
{
    bool is =
        name == contextOption.name || std::any_of(std::begin(compoundOptions), std::end(compoundOptions),
                                                  [&](const TypedOption& compound) { return compound.name == name; });
    forEachOption(SceneDescription{},
                  [&](const Option& option, const auto&, const auto&) { is = is || option.name == name; });
    return is;
}

/// The name that `text` begins with, as Python says it, and how long it was.
struct Found {
    std::string name;
    std::size_t letters;
};

std::optional<Found> optionAt(std::string_view text)
{
    if (!text.starts_with(kDashes)) return std::nullopt;
    const auto* const end = std::find_if_not(text.begin(), text.end(), isInWord);
    const std::string_view name = text.substr(0, std::size_t(end - text.begin()));
    if (!isOfScene(name)) return std::nullopt;
    return Found{pythonName(name), name.size()};
}

/// "surfaces[1].colorBy".
std::optional<Found> itemAt(std::string_view text)
{
    if (!text.starts_with(kListedSurface)) return std::nullopt;
    const std::size_t close = text.find("].");
    if (close == std::string_view::npos) return std::nullopt;
    const auto* const end = std::find_if_not(text.begin() + std::ptrdiff_t(close) + 2, text.end(), isInWord);
    const std::size_t letters = std::size_t(end - text.begin());
    const std::string_view key = text.substr(close + 2, letters - close - 2);
    const std::string index(text.substr(kListedSurface.size(), close - kListedSurface.size()));
    return Found{"surface[" + index + "]: " + (key == options::surface.own ? options::surface.key : snakeCase(key)),
                 letters};
}

}  // namespace

std::string pythonName(std::string_view name)
{
    std::string snake(name.starts_with(kDashes) ? name.substr(kDashes.size()) : name);
    std::replace(snake.begin(), snake.end(), '-', '_');
    return snake;
}

std::string inPythonsWords(std::string_view message)
{
    std::string said;
    for (std::size_t i = 0; i < message.size();) {
        const bool wordBegins =
            i == 0 || (!isInWord(message[i - 1]) && message[i - 1] != '\'' && message[i - 1] != '/');
        const std::string_view rest = message.substr(i);
        std::optional<Found> found;
        if (wordBegins) found = i == 0 && rest.front() != '-' ? itemAt(rest) : optionAt(rest);
        said += found ? found->name : std::string(1, message[i]);
        i += found ? found->letters : 1;
    }
    return said;
}

}  // namespace aeolic
