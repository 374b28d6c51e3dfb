#include "reader/tecplot/tecplot_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "aeolic/error.h"
#include "base/text.h"
#include "reader/binary/numbers.h"
#include "reader/binary/whole_file.h"

namespace aeolic {
namespace {

constexpr std::size_t kBeginning = std::size_t{1} << 12;  // Where bytes that are no text tell a binary file.

/// A zone's numbers one after the other; "12*0.5" is twelve of them.
class Numbers {
public:
    explicit Numbers(std::string_view text) : text_(text) {}

    std::size_t taken() const { return taken_; }

    /// False at the end, or where no number stands.
    bool next(double& value)
    {
        if (repeats_ == 0 && !readNext()) return false;
        --repeats_;
        ++taken_;
        value = value_;
        return true;
    }

    bool atEnd()
    {
        skip();
        return repeats_ == 0 && at_ >= text_.size();
    }

    /// The text that stands where a number should.
    std::string word()
    {
        skip();
        std::string word(text_.substr(at_, std::min<std::size_t>(20, text_.find_first_of(" \t\r\n,", at_) - at_)));
        return withoutControls(std::move(word), '?');
    }

private:
    void skip()
    {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',')
                ++at_;
            else
                return;
        }
    }

    bool readNext()
    {
        skip();
        if (at_ >= text_.size() || !readValue()) return false;
        repeats_ = 1;
        if (at_ >= text_.size() || text_[at_] != '*') return true;
        constexpr double most = 1e12;
        if (!(value_ >= 1 && value_ <= most) || value_ != std::floor(value_)) return false;
        const auto count = std::uint64_t(value_);
        ++at_;
        if (!readValue()) return false;
        repeats_ = count;
        return true;
    }

    bool readValue()
    {
        const auto [stop, error] = readReal(text_.data() + at_, text_.data() + text_.size(), value_);
        if (error != std::errc{}) return false;
        at_ = std::size_t(stop - text_.data());
        return at_ >= text_.size() || std::string_view(" \t\r\n,*#").find(text_[at_]) != std::string_view::npos;
    }

    std::string_view text_;
    std::size_t at_ = 0, taken_ = 0;
    std::uint64_t repeats_ = 0;
    double value_ = 0;
};

}  // namespace

std::size_t tecplotCorners(TecplotCells cells)
{
    constexpr std::size_t corners[] = {0, 2, 3, 4, 4, 8, 0, 0};
    return corners[std::size_t(cells)];
}

std::int64_t TecplotZone::cellCount() const
{
    if (cells != TecplotCells::ordered) return elements;
    std::int64_t product = 1;
    for (const std::int64_t length : lengths) product *= std::max<std::int64_t>(length - 1, 1);
    return product;
}

int TecplotZone::dimension() const
{
    constexpr int dimensions[] = {0, 1, 2, 2, 3, 3, 2, 3};
    if (cells != TecplotCells::ordered) return dimensions[std::size_t(cells)];
    return int(std::count_if(lengths, lengths + 3, [](std::int64_t length) { return length > 1; }));
}

TecplotText::TecplotText(const std::string& path) : path_(path), data_(wholeFile(path))
{
    if (data_.starts_with("#!TD"))
        throw InputError(path, "it is a Tecplot file in binary",
                         "one in text, as Tecplot 360 writes it (File > Write Data)");
    if (data_.find('\0') < kBeginning) throw InputError(path, "it is not text", "a Tecplot file in text");
    TecplotHeads heads = readTecplotHeads(data_, path_);
    variables_ = std::move(heads.variables);
    zones_ = std::move(heads.zones);
    if (zones_.empty()) throw InputError(path, "it has no zones", "a Tecplot file with data");
}

void TecplotText::fail(const TecplotZone& zone, const std::string& found, const std::string& expected) const
{
    throw InputError(path_, fmt::format("'{}': {}", zone.name, found), expected);
}

/// `columns`: where each of the file's variables goes in `values`. The elements follow, if `corners` is not null.
void TecplotText::take(const TecplotZone& zone, const std::vector<std::optional<std::size_t>>& columns,
                       std::vector<std::vector<double>>& values, std::vector<std::int64_t>* corners) const
{
    Numbers numbers(std::string_view(data_).substr(zone.begin, zone.end - zone.begin));
    const auto next = [&] {
        double value = 0;
        if (!numbers.next(value)) {
            if (numbers.atEnd())
                fail(zone, fmt::format("it ends behind {} numbers", numbers.taken()), "more, by its sizes");
            fail(zone, fmt::format("found '{}' behind {} numbers", numbers.word(), numbers.taken()), "a number");
        }
        return value;
    };
    const auto points = std::size_t(zone.points()), cells = std::size_t(zone.cellCount());
    const auto present = [&](std::size_t v) { return !zone.passive[v] && !zone.shared[v]; };
    for (std::size_t v = 0; v < columns.size(); ++v)
        if (columns[v] && present(v)) {
            if (zone.inCells[v] && !zone.block)
                fail(zone, "it has values in cells, point after point", "DATAPACKING=BLOCK");
            values[*columns[v]].reserve(zone.inCells[v] ? cells : points);
        }
    const auto takeOne = [&](std::size_t v) {
        const double value = next();
        if (columns[v]) values[*columns[v]].push_back(value);
    };
    if (zone.block) {
        for (std::size_t v = 0; v < columns.size(); ++v)
            for (std::size_t i = 0; present(v) && i < (zone.inCells[v] ? cells : points); ++i) takeOne(v);
    } else {
        for (std::size_t i = 0; i < points; ++i)
            for (std::size_t v = 0; v < columns.size(); ++v)
                if (present(v)) takeOne(v);
    }
    const bool elements = zone.cells != TecplotCells::ordered && !zone.sharedCells;
    if (elements && corners) {
        const std::size_t count = cells * tecplotCorners(zone.cells);
        corners->reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double corner = next();
            if (!(corner == std::floor(corner)))  // Also true for NaN.
                fail(zone, fmt::format("an element has the corner {}", corner), "a whole number");
            corners->push_back(std::int64_t(std::clamp(corner, -1e18, 1e18)));
        }
    }
    if ((!elements || corners) && !zone.neighbours && !numbers.atEnd())
        fail(zone, fmt::format("'{}' stands behind its {} numbers", numbers.word(), numbers.taken()),
             "no more, by its sizes");
}

std::vector<std::vector<double>> TecplotText::read(std::size_t number, const std::vector<std::size_t>& wanted) const
{
    const TecplotZone& zone = zones_[number];
    std::vector<std::vector<double>> values(wanted.size());
    std::vector<std::optional<std::size_t>> columns(variables_.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) columns[wanted[i]] = i;
    take(zone, columns, values, nullptr);
    std::map<std::size_t, std::vector<std::size_t>> ofZones;  // Which of those wanted are another zone's.
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (const auto from = zone.shared[wanted[i]]) ofZones[*from].push_back(i);
    for (const auto& [from, places] : ofZones) {
        std::vector<std::size_t> theirs;
        for (const std::size_t i : places) theirs.push_back(wanted[i]);
        auto read = this->read(from, theirs);  // It has them itself.
        for (std::size_t k = 0; k < places.size(); ++k) {
            const std::size_t v = theirs[k];
            const auto expected = std::size_t(zone.inCells[v] ? zone.cellCount() : zone.points());
            if (!read[k].empty() && read[k].size() != expected)
                fail(zone, fmt::format("it shares '{}' of a zone that has {} values", variables_[v], read[k].size()),
                     fmt::format("{}", expected));
            values[places[k]] = std::move(read[k]);
        }
    }
    return values;
}

std::vector<std::int64_t> TecplotText::corners(std::size_t number) const
{
    const TecplotZone& zone = zones_[number];
    if (tecplotCorners(zone.cells) == 0)
        fail(zone, "its elements are polygons or polyhedra", "triangles, quadrilaterals, tetrahedra or bricks");
    if (zone.sharedCells) {
        const TecplotZone& other = zones_[*zone.sharedCells];
        if (other.cells != zone.cells || other.elements != zone.elements)
            fail(zone, "it shares elements of another kind or number", "a zone with the same elements");
        return corners(*zone.sharedCells);
    }
    std::vector<std::vector<double>> values;
    std::vector<std::int64_t> corners;
    take(zone, std::vector<std::optional<std::size_t>>(variables_.size()), values, &corners);
    return corners;
}

}  // namespace aeolic
