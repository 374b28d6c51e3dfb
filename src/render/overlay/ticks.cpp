#include "render/overlay/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

namespace {

constexpr int largestPlain = 5, smallestPlain = -3;  // Exponents of the largest value that is written without a factor.

int exponentOf(double magnitude)
{
    return magnitude > 0 ? int(std::floor(std::log10(magnitude))) : 0;
}

double scaled(double mantissa, int exponent)
{
    // Dividing by an exact power of ten keeps 3e-1 the same double as the literal 0.3. In two halves: 1e-320 has no
    // inverse.
    if (exponent >= 0) return mantissa * std::pow(10.0, exponent);
    const int half = exponent / 2;
    return mantissa / std::pow(10.0, -half) / std::pow(10.0, half - exponent);
}

std::string withMinus(std::string text)
{
    if (text.find_first_of("123456789") == std::string::npos && text.starts_with('-')) text.erase(0, 1);  // "-0.0"
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

std::string powerOfTen(int exponent)
{
    static constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "×10⁻" : "×10";
    for (char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
    return text;
}

struct Step {
    int mantissa = 1, exponent = 0;  ///< mantissa (1, 2 or 5) * 10^exponent

    double size() const { return scaled(mantissa, exponent); }
    // A hair of tolerance: 0.3 / 0.1 must count as 3.
    double firstIndex(double lo) const { return std::ceil(lo / size() - 1e-9); }
    double lastIndex(double hi) const { return std::floor(hi / size() + 1e-9); }
};

Step roundStep(double lo, double hi, int most)
{
    for (int exponent = exponentOf(hi / most - lo / most);; ++exponent)
        for (int mantissa : {1, 2, 5}) {
            const Step step{mantissa, exponent};
            if (step.lastIndex(hi) - step.firstIndex(lo) + 1 <= most) return step;
        }
}

}  // namespace

Ticks niceTicks(double lo, double hi, int most)
{
    Ticks ticks;
    const double magnitude = std::max(std::abs(lo), std::abs(hi));
    const int exponent = exponentOf(magnitude);
    const bool factored = magnitude > 0 && (exponent > largestPlain || exponent < smallestPlain);
    if (factored) ticks.factor = powerOfTen(exponent);
    const int unit = factored ? exponent : 0;

    if (!(hi / 2 - lo / 2 > magnitude * 1e-12)) {
        ticks.values = {lo};
        ticks.labels = {withMinus(fmt::format("{:.6g}", scaled(lo, -unit)))};
        return ticks;
    }
    const Step step = roundStep(lo, hi, most);
    const int decimals = std::max(0, unit - step.exponent);
    for (double i = step.firstIndex(lo); i <= step.lastIndex(hi); ++i) {
        ticks.values.push_back(std::clamp(scaled(i * step.mantissa, step.exponent), lo, hi));
        ticks.labels.push_back(
            withMinus(fmt::format("{:.{}f}", scaled(i * step.mantissa, step.exponent - unit), decimals)));
    }
    return ticks;
}

namespace {

/// A value with at most so many digits: "0.25", "2×10⁻⁷".
std::string labelOf(double value, int digits)
{
    const int exponent = exponentOf(std::abs(value));
    if (value == 0 || (exponent <= largestPlain && exponent >= smallestPlain))
        return withMinus(fmt::format("{:.{}g}", value, std::max(digits, exponent + 1)));
    const std::string mantissa = withMinus(fmt::format("{:.{}g}", scaled(value, -exponent), digits));
    return mantissa == "1" ? powerOfTen(exponent).substr(std::string_view("×").size())
                           : mantissa + powerOfTen(exponent);
}

/// Multiples of powers of ten from lo to hi.
Ticks multiplesIn(double lo, double hi, std::initializer_list<int> mantissas, int everyNth)
{
    Ticks ticks;
    for (int exponent = exponentOf(lo); exponent <= exponentOf(hi) + 1; ++exponent)
        for (const int mantissa : mantissas) {
            const double value = scaled(mantissa, exponent);
            // A hair of tolerance: ends that were rounded to float still get their tick.
            if (exponent % everyNth != 0 || value < lo * (1 - 1e-6) || value > hi * (1 + 1e-6)) continue;
            ticks.values.push_back(std::clamp(value, lo, hi));
            ticks.labels.push_back(labelOf(value, 1));
        }
    return ticks;
}

}  // namespace

Ticks logTicks(double lo, double hi, int most)
{
    for (int everyNth = 1;; ++everyNth) {
        Ticks powers = multiplesIn(lo, hi, {1}, everyNth);
        if (int(powers.values.size()) > most) continue;
        if (powers.values.size() >= 3) return powers;
        break;
    }
    for (const auto& mantissas : {std::initializer_list<int>{1, 2, 5}, {1, 3}, {1}}) {
        Ticks multiples = multiplesIn(lo, hi, mantissas, 1);
        if (multiples.values.size() >= 2 && int(multiples.values.size()) <= most) return multiples;
    }
    return niceTicks(lo, hi, most);
}

namespace {

/// The least number of digits, 4 or more, with which every value is written to within a fiftieth of `width`.
int digitsFor(const std::vector<double>& values, double width)
{
    constexpr int least = 4, most = 15;
    const auto tells = [&](int digits) {
        return std::all_of(values.begin(), values.end(), [&](double value) {
            return std::abs(std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr) - value) <= width / 50;
        });
    };
    int digits = least;
    while (digits < most && !tells(digits)) ++digits;
    return digits;
}

/// Which of the edges 0 to `bands` have ticks: both ends, and every n-th between them, n as small as `most` allows.
/// Where another n, at most twice as large, meets the upper end, it is taken. Else the last gap is the widest.
std::vector<int> tickedEdges(int bands, int most)
{
    const int least = (bands + most - 1) / most;
    int everyNth = least;
    while (bands % everyNth != 0 && everyNth < 2 * least) ++everyNth;
    if (bands % everyNth != 0) everyNth = least;
    std::vector<int> edges;
    for (int i = 0; i + everyNth <= bands; i += everyNth) edges.push_back(i);
    edges.push_back(bands);
    return edges;
}

}  // namespace

Ticks bandTicks(double lo, double hi, int bands, int most)
{
    Ticks ticks;
    const double width = hi / bands - lo / bands;
    for (const int i : tickedEdges(bands, most)) {
        const double part = double(i) / bands, value = i == bands ? hi : lo * (1 - part) + hi * part;
        ticks.values.push_back(std::abs(value) < 1e-9 * width ? 0 : value);  // What is 0 but for rounding is 0.
    }
    const int digits = digitsFor(ticks.values, width);
    for (const double value : ticks.values) ticks.labels.push_back(labelOf(value, digits));
    return ticks;
}

}  // namespace aeolic
