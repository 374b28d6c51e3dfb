#include "reader/tecplot/tecplot_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "aeolic/error.h"
#include "base/text.h"

namespace aeolic {
namespace {

constexpr std::string_view kRecords[] = {"TITLE",        "VARIABLES",      "ZONE",       "TEXT",    "GEOMETRY",
                                         "CUSTOMLABELS", "DATASETAUXDATA", "VARAUXDATA", "FILETYPE"};

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',';
}

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isOfNumber(char c)
{
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
}

std::string upper(std::string_view text)
{
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
    return out;
}

/// Reads what the records of a Tecplot file say, and passes over its numbers.
class HeadsText {
public:
    HeadsText(std::string_view text, const std::string& path) : text_(text), path_(path) {}

    TecplotHeads read()
    {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // The mark of UTF-8.
        skipBlank();
        if (at_ >= text_.size() || !isLetter(text_[at_]) || !atRecord())
            fail("does not begin like a Tecplot file in text", "TITLE, VARIABLES or ZONE");
        while (at_ < text_.size()) {
            const std::string record = word();
            if (record == "VARIABLES") {
                readVariables();
            } else if (record == "ZONE") {
                readZone();
            } else {
                if (record == "FILETYPE" || record == "TITLE") {  // More may stand behind it in the line.
                    skipBlank();
                    if (at_ < text_.size() && text_[at_] == '=') ++at_;
                    const std::string said = value();
                    if (record == "FILETYPE" && upper(said) != "FULL")
                        fail(fmt::format("says that the file is of the type {}", upper(said)), "FULL");
                } else {
                    at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
                }
            }
            skipToRecord();
        }
        return std::move(found_);
    }

private:
    [[noreturn]] void fail(const std::string& found, const std::string& wanted) const
    {
        const auto line =
            std::count(text_.begin(), text_.begin() + std::ptrdiff_t(std::min(at_, text_.size())), '\n') + 1;
        throw InputError(path_, fmt::format("line {} {}", line, found), wanted);
    }

    /// Blanks, commas, and comments up to the ends of their lines.
    void skipBlank()
    {
        while (at_ < text_.size()) {
            if (text_[at_] == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (isBlank(text_[at_]))
                ++at_;
            else
                return;
        }
    }

    /// Whether a word that begins a record stands here.
    bool atRecord() const
    {
        std::size_t end = at_;
        while (end < text_.size() && isLetter(text_[end])) ++end;
        const std::string found = upper(text_.substr(at_, end - at_));
        return std::ranges::find(kRecords, found) != std::end(kRecords);
    }

    std::string word()
    {
        const std::size_t begin = at_;
        while (at_ < text_.size() && (isLetter(text_[at_]) || (at_ > begin && isOfNumber(text_[at_])))) ++at_;
        return upper(text_.substr(begin, at_ - begin));
    }

    std::string quoted()
    {
        const char sign = text_[at_++];
        std::string value;
        for (; at_ < text_.size() && text_[at_] != sign; ++at_) {
            if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
            value += text_[at_];
        }
        if (at_ >= text_.size()) fail("a text in quotes does not end", "a second quote");
        ++at_;
        return withoutControls(value, '?');
    }

    /// The value behind '=': a text in quotes, a list in parentheses with them, or letters up to a blank.
    std::string value()
    {
        skipBlank();
        if (at_ >= text_.size()) fail("a value is missing at the end of the file", "one");
        if (text_[at_] == '"' || text_[at_] == '\'') return quoted();
        const std::size_t begin = at_;
        if (text_[at_] == '(' || text_[at_] == '[') {
            for (int depth = 0; at_ < text_.size();) {
                const char c = text_[at_++];
                depth += (c == '(' || c == '[') - (c == ')' || c == ']');
                if (depth == 0) return withoutControls(withSpaces(std::string(text_.substr(begin, at_ - begin))), '?');
            }
            fail("a list does not end", "')'");
        }
        while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
        return withoutControls(std::string(text_.substr(begin, at_ - begin)), '?');
    }

    /// To the next line that begins with a word of a record.
    void skipToRecord()
    {
        while (at_ < text_.size()) {
            std::size_t begin = at_;
            while (begin < text_.size() && (text_[begin] == ' ' || text_[begin] == '\t')) ++begin;
            if (begin < text_.size() && isLetter(text_[begin])) {
                const std::size_t line = at_;
                at_ = begin;
                if (atRecord()) return;
                at_ = line;
            }
            at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
        }
    }

    void readVariables()
    {
        skipBlank();
        if (at_ < text_.size() && text_[at_] == '=') ++at_;
        found_.variables.clear();
        for (skipBlank(); at_ < text_.size() && !atRecord(); skipBlank()) found_.variables.push_back(value());
        if (found_.variables.empty()) fail("names no variables", "names");
    }

    void readZone()
    {
        if (found_.variables.empty()) fail("has a zone, and no variables were named before", "VARIABLES");
        TecplotZone zone;
        zone.name = fmt::format("zone {}", found_.zones.size() + 1);
        zone.inCells.assign(found_.variables.size(), false);
        zone.passive.assign(found_.variables.size(), false);
        zone.shared.assign(found_.variables.size(), std::nullopt);
        for (skipBlank(); at_ < text_.size() && isLetter(text_[at_]) && !atRecord(); skipBlank()) {
            const std::size_t begin = at_;
            const std::string key = word();
            skipBlank();
            if (key == "AUXDATA") {  // Another name, '=' and its value.
                while (at_ < text_.size() && text_[at_] != '=' && text_[at_] != '\n') ++at_;
            }
            if (at_ >= text_.size() || text_[at_] != '=') {  // "NaN" among the numbers.
                at_ = begin;
                break;
            }
            ++at_;
            setKey(zone, key, value());
        }
        if (zone.cells != TecplotCells::ordered) zone.lengths[1] = zone.lengths[2] = 1;
        zone.begin = at_;
        skipToRecord();
        zone.end = at_;
        while (zone.end > zone.begin && text_[zone.end - 1] != '\n' && zone.end < text_.size()) --zone.end;
        found_.zones.push_back(std::move(zone));
    }

    std::int64_t whole(const std::string& key, const std::string& value) const
    {
        const auto number = wholeTextAs<std::int64_t>(value);
        if (!number) fail(fmt::format("has the {} '{:.40}'", key, value), "a whole number");
        return *number;
    }

    void setKey(TecplotZone& zone, const std::string& key, const std::string& value)
    {
        const auto length = [&](std::int64_t least) {
            const std::int64_t number = whole(key, value);
            if (number < least) fail(fmt::format("has the {} {}", key, number), fmt::format("{} or more", least));
            return number;
        };
        if (key == "T" && !value.empty()) zone.name = value;
        if (key == "I" || key == "N" || key == "NODES") zone.lengths[0] = length(1);
        if (key == "J") zone.lengths[1] = length(1);
        if (key == "K") zone.lengths[2] = length(1);
        if (key == "E" || key == "ELEMENTS") zone.elements = length(0);
        if (key == "ZONETYPE" || key == "ET" || key == "F" || key == "DATAPACKING") setType(zone, key, upper(value));
        if (key == "VARLOCATION") setLocations(zone, value);
        if (key == "VARSHARELIST") setShared(zone, value);
        if (key == "PASSIVEVARLIST")
            for (const std::size_t variable : numbersIn(value, found_.variables.size()))
                zone.passive[variable - 1] = true;
        if (key == "D") fail("repeats variables by 'D'", "VARSHARELIST");
        if (key == "FACENEIGHBORCONNECTIONS") zone.neighbours = true;
        if (key == "STRANDID") zone.strand = whole(key, value);
        if (key == "CONNECTIVITYSHAREZONE") {
            const std::int64_t number = length(1);
            if (number > std::int64_t(found_.zones.size()))
                fail(fmt::format("shares the elements of zone {}", number), "a zone before");
            const auto other = std::size_t(number - 1);
            zone.sharedCells =
                found_.zones[other].sharedCells.value_or(other);  // Whose they are in the end: a step, not a walk.
        }
        if (key == "SOLUTIONTIME") {
            const auto time = wholeTextAs<double>(value);
            if (!time || !std::isfinite(*time))
                fail(fmt::format("has the SOLUTIONTIME '{:.40}'", value), "a finite number");
            zone.time = *time;
        }
    }

    void setType(TecplotZone& zone, const std::string& key, const std::string& value)
    {
        struct Name {
            const char* name;
            TecplotCells cells;
        };
        constexpr Name types[] = {
            {"ORDERED", TecplotCells::ordered},          {"FELINESEG", TecplotCells::lines},
            {"FETRIANGLE", TecplotCells::triangles},     {"FEQUADRILATERAL", TecplotCells::quads},
            {"FETETRAHEDRON", TecplotCells::tetrahedra}, {"FEBRICK", TecplotCells::bricks},
            {"FEPOLYGON", TecplotCells::polygons},       {"FEPOLYHEDRON", TecplotCells::polyhedra}};
        if (key == "DATAPACKING" || key == "F") {
            if (value.ends_with("BLOCK"))
                zone.block = true;
            else if (!value.ends_with("POINT"))
                fail(fmt::format("has the {} {:.40}", key, value), "POINT or BLOCK");
            if (key == "F" && value.starts_with("FE") && zone.cells == TecplotCells::ordered)
                zone.cells = TecplotCells::quads;
            return;
        }
        const std::string name = key == "ET" ? "FE" + value : value;
        for (const Name& type : types)
            if (name == type.name) {
                zone.cells = type.cells;
                return;
            }
        fail(fmt::format("has the {} {:.40}", key, value), "a type of Tecplot");
    }

    /// "[1,3-5]", "(2)": numbers from 1 to `most`.
    std::vector<std::size_t> numbersIn(std::string_view list, std::size_t most) const
    {
        std::vector<std::size_t> numbers;
        std::size_t at = 0;
        std::optional<std::size_t> first;
        while (at < list.size()) {
            const char c = list[at];
            if (c >= '0' && c <= '9') {
                std::size_t number = 0;
                const auto [end, error] = std::from_chars(list.data() + at, list.data() + list.size(), number);
                if (error != std::errc{} || number < 1 || number > most || (first && *first > number))
                    fail(fmt::format("has the list '{:.40}'", std::string(list)),
                         fmt::format("numbers from 1 to {}", most));
                for (std::size_t each = first.value_or(number); each <= number; ++each) numbers.push_back(each);
                first.reset();
                at = std::size_t(end - list.data());
                continue;
            }
            if (c == '-' && !numbers.empty()) {
                first = numbers.back();
                numbers.pop_back();
            }
            ++at;
        }
        return numbers;
    }

    /// "([3-5]=CELLCENTERED,[6]=NODAL)", or a word for each variable.
    void setLocations(TecplotZone& zone, const std::string& value) const
    {
        const std::string text = upper(value);
        if (text.find('[') == std::string::npos && text.find('=') == std::string::npos) {
            std::size_t variable = 0;
            for (std::size_t at = 0; at < text.size() && variable < found_.variables.size();) {
                const std::size_t begin = text.find_first_of("CN", at);
                if (begin == std::string::npos) break;
                zone.inCells[variable++] = text[begin] == 'C';
                at = std::min(text.find_first_of(" ,\t\n\r)", begin), text.size());
            }
            return;
        }
        for (std::size_t at = 0;;) {
            const std::size_t sign = text.find('=', at);
            if (sign == std::string::npos) return;
            const bool cells = text.find("CELL", sign) < text.find_first_of(",)", sign);
            for (const std::size_t variable :
                 numbersIn(std::string_view(text).substr(at, sign - at), found_.variables.size()))
                zone.inCells[variable - 1] = cells;
            at = std::min(text.find_first_of(",)", sign), text.size());
        }
    }

    /// "([1-3]=2,[5])": of which zone a variable is; without a number of the one before.
    void setShared(TecplotZone& zone, const std::string& value) const
    {
        if (found_.zones.empty()) fail("shares variables, and it is the first zone", "a zone before");
        for (std::size_t at = value.find('['); at != std::string::npos; at = value.find('[', at + 1)) {
            const std::size_t end = std::min(value.find(']', at), value.size());
            std::size_t from = found_.zones.size();
            if (end + 1 < value.size() && value[end + 1] == '=') {
                const std::size_t stop = std::min(value.find_first_of(",) ", end), value.size());
                from = std::size_t(
                    std::max<std::int64_t>(0, whole("VARSHARELIST", value.substr(end + 2, stop - end - 2))));
            }
            if (from < 1 || from > found_.zones.size())
                fail(fmt::format("shares variables of zone {}", from), "a zone before");
            for (const std::size_t variable :
                 numbersIn(std::string_view(value).substr(at, end - at), found_.variables.size()))
                zone.shared[variable - 1] = found_.zones[from - 1].shared[variable - 1].value_or(from - 1);
        }
    }

    std::string_view text_;
    const std::string& path_;
    std::size_t at_ = 0;
    TecplotHeads found_;
};

}  // namespace

TecplotHeads readTecplotHeads(std::string_view text, const std::string& path)
{
    return HeadsText(text, path).read();
}

}  // namespace aeolic
