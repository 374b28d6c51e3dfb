#pragma once

#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

/// The number that all of the text is; nothing where it is something else.
template <class Number>
std::optional<Number> foamNumber(std::string_view text)
{
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

bool isFoamFolder(const std::filesystem::path& path);

/// What is in a folder, sorted. Nothing where it cannot be looked into.
std::vector<std::string> namesInFolder(const std::filesystem::path& folder);

/// The folders whose name is a time and that hold data of it, by time.
std::map<double, std::string> foamTimeFolders(const std::filesystem::path& folder);

}  // namespace aeolic
