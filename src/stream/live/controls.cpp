#include "stream/live/controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "description/option_rules.h"

namespace aeolic::stream {
namespace {

constexpr std::size_t kLongestName = 64;  // Bytes, as of all names in the protocol.
constexpr std::size_t kMostControls = 64;
constexpr double kMostPresses = 1e9;
constexpr const char* kKinds[] = {"number", "toggle", "button"};

bool isWithin(const Control& control, double value)
{
    if (!std::isfinite(value)) return false;
    if (control.kind == Control::Kind::number) return value >= control.lo && value <= control.hi;
    if (control.kind == Control::Kind::toggle) return value == 0 || value == 1;
    return value >= 0 && value <= kMostPresses && value == std::floor(value);
}

std::string expectedOf(const Control& control)
{
    if (control.kind == Control::Kind::number) return fmt::format("a number from {:g} to {:g}", control.lo, control.hi);
    return control.kind == Control::Kind::toggle ? "0 or 1" : "how often it was pressed";
}

/// Browsers are told in JSON.
void requireUtf8(const std::string& where, const std::string& text)
{
    if (!isUtf8(text)) throw InputError(where, "found " + inQuotes(text), "text in UTF-8");
}

void check(const Control& control, double value)
{
    if (!isWithin(control, value))
        throw InputError("control " + control.name, fmt::format("found {:g}", value), expectedOf(control));
}

}  // namespace

Controls::Controls(std::string title, std::vector<Control> controls)
    : title_(std::move(title)), controls_(std::move(controls))
{
    if (controls_.size() > kMostControls)
        throw InputError("controls", fmt::format("found {}", controls_.size()),
                         fmt::format("at most {}", kMostControls));
    requireUtf8("title", title_);
    for (const Control& control : controls_) {
        requireUtf8("control", control.name);
        requireUtf8("control " + control.name, control.unit);
        if (control.name.empty() || control.name.size() > kLongestName)
            throw InputError("control", fmt::format("found a name of {} bytes", control.name.size()),
                             fmt::format("1 to {}", kLongestName));
        if (std::size_t(control.kind) >= std::size(kKinds))
            throw InputError("control " + control.name, fmt::format("found kind {}", int(control.kind)),
                             "number, toggle or button");
        const auto isSame = [&](const Control& other) { return other.name == control.name; };
        if (std::count_if(controls_.begin(), controls_.end(), isSame) > 1)
            throw InputError("control " + control.name, "found twice", "names that are different");
        if (!std::isfinite(control.lo) || !std::isfinite(control.hi) || !(control.lo < control.hi))
            throw InputError("control " + control.name, fmt::format("found {:g} to {:g}", control.lo, control.hi),
                             "a range of finite numbers, the smaller one first");
        check(control, control.value);
    }
}

const Control& Controls::find(const std::string& name) const
{
    for (const Control& control : controls_)
        if (control.name == name) return control;
    throw std::out_of_range("there is no control '" + name + "'");
}

void Controls::set(const std::string& name, double value)
{
    auto& control = const_cast<Control&>(find(name));
    if (std::isnan(value)) return;
    if (control.kind == Control::Kind::number) value = std::clamp(value, control.lo, control.hi);
    if (control.kind == Control::Kind::toggle) value = value != 0;
    if (isWithin(control, value)) control.value = value;
}

void Controls::apply(const Json& asked)
{
    std::vector<std::string> names;
    for (const Control& control : controls_) names.push_back(control.name);
    for (const auto& [name, value] : asked.items()) {
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw InputError("change: steer", "found '" + name + "'",
                             "a control of the program" + didYouMean(name, names));
        check(find(name), value.get<double>());
    }
    for (const auto& [name, value] : asked.items()) set(name, value.get<double>());
}

Json Controls::toJson() const
{
    Json list = Json::array();
    for (const Control& control : controls_)
        list.push_back({{"name", control.name},
                        {"kind", kKinds[int(control.kind)]},
                        {"value", control.value},
                        {"lo", control.lo},
                        {"hi", control.hi},
                        {"unit", control.unit}});
    return {{"title", title_}, {"controls", list}};
}

}  // namespace aeolic::stream
