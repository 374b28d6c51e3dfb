#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/memory.h"
#include "base/text.h"
#include "data/binary/byte_cursor.h"
#include "data/binary/file_bytes.h"
#include "data/netcdf/netcdf_file.h"

namespace aeolic {
namespace {

constexpr char kHeader[] = "the netCDF header";
constexpr std::uint64_t kFirstHeader = 1 << 20, kMostHeader = 1 << 28, kMostValues = std::uint64_t{1} << 60;
constexpr std::uint32_t kDimensions = 10, kVariables = 11, kAttributes = 12;
constexpr int kCharacters = 2;

struct Variable {
    std::vector<std::uint64_t> shape;  // With the records as the first dimension, where it has them.
    bool records = false;
    int type = 0;
    std::uint64_t begin = 0;
    std::map<std::string, std::string> texts;

    std::uint64_t elementBytes() const;
    std::uint64_t perRecord() const;  // Elements of one record, or of all that has none.
};

std::optional<NumberType> numberType(int type)
{
    constexpr NumberType types[] = {NumberType::int8,    NumberType::int8,    NumberType::int16, NumberType::int32,
                                    NumberType::float32, NumberType::float64, NumberType::uint8, NumberType::uint16,
                                    NumberType::uint32,  NumberType::int64,   NumberType::uint64};
    if (type < 1 || type > 11) return std::nullopt;
    return types[type - 1];
}

std::uint64_t Variable::elementBytes() const
{
    return bytesOf(*numberType(type));
}

std::uint64_t Variable::perRecord() const
{
    return productOf({shape.begin() + (records ? 1 : 0), shape.end()});
}

/// "The NetCDF Classic Format Specification", and its extension CDF-5.
class ClassicNetcdf : public NetcdfFile {
public:
    explicit ClassicNetcdf(const std::string& path) : NetcdfFile(path), file_(path)
    {
        // How long the header is, is known at its end.
        for (std::uint64_t length = kFirstHeader;; length *= 16) {
            const std::uint64_t bytes = std::min(length, file_.size());
            try {
                readHeader(bytes);
                break;
            } catch (const InputError&) {
                if (bytes == file_.size() || length >= kMostHeader) throw;
            }
        }
    }

    std::optional<std::uint64_t> dimension(const std::string& name) const override
    {
        for (const auto& [each, length] : dimensions_)
            if (each == name) return length;
        return std::nullopt;
    }

    std::size_t variableCount() const override { return variables_.size(); }
    bool has(const std::string& variable) const override { return variables_.contains(variable); }
    std::vector<std::uint64_t> shape(const std::string& variable) const override { return find(variable).shape; }

    std::optional<NumberType> type(const std::string& variable) const override
    {
        const int type = find(variable).type;
        return type == kCharacters ? std::nullopt : numberType(type);
    }

    std::optional<std::string> text(const std::string& variable, const std::string& attribute) const override
    {
        const auto& texts = find(variable).texts;
        const auto found = texts.find(attribute);
        return found == texts.end() ? std::nullopt : std::optional(found->second);
    }

    std::vector<float> floats(const std::string& variable, const Slab& slab) const override
    {
        return read<float>(variable, slab);
    }
    std::vector<double> doubles(const std::string& variable, const Slab& slab) const override
    {
        return read<double>(variable, slab);
    }
    std::vector<std::int64_t> wholes(const std::string& variable, const Slab& slab) const override
    {
        return read<std::int64_t>(variable, slab);
    }

protected:
    std::vector<std::uint8_t> characters(const std::string& variable) const override
    {
        const auto values = read<std::int8_t>(variable, wholeSlab(find(variable).shape));
        return {values.begin(), values.end()};
    }

private:
    void readHeader(std::uint64_t bytes)
    {
        dimensions_.clear();
        variables_.clear();
        const auto data = file_.read(0, bytes, kHeader);
        ByteCursor cursor(data, path(), kHeader, true);
        cursor.expect("CDF");
        const int version = cursor.u8();
        if (version != 1 && version != 2 && version != 5)
            fail(fmt::format("its netCDF version is {}", version), "1, 2 or 5, or netCDF-4");
        countBytes_ = version == 5 ? 8 : 4;
        const std::size_t offsetBytes = version == 1 ? 4 : 8;
        records_ = cursor.whole(countBytes_);
        const bool streamed = records_ == (version == 5 ? ~std::uint64_t{0} : 0xffffffff);
        readList(cursor, kDimensions, [&] {
            const std::string name = readName(cursor);
            dimensions_.emplace_back(name, cursor.whole(countBytes_));
        });
        std::map<std::string, std::string> ignored;
        readAttributes(cursor, ignored);
        readList(cursor, kVariables, [&] {
            const std::string name = readName(cursor);
            Variable variable;
            const std::uint64_t rank = cursor.whole(countBytes_);
            std::uint64_t product = 1;
            for (std::uint64_t i = 0; i < rank; ++i) {
                const std::uint64_t number = cursor.whole(countBytes_);
                if (number >= dimensions_.size()) cursor.fail("has a variable of a dimension that is not there");
                const std::uint64_t length = dimensions_[number].second;
                if (length == 0 && i == 0) variable.records = true;
                variable.shape.push_back(length);
                if (length > kMostValues || product > kMostValues / std::max<std::uint64_t>(length, 1))
                    cursor.fail("has a variable of too many elements");
                product *= std::max<std::uint64_t>(length, 1);
            }
            readAttributes(cursor, variable.texts);
            variable.type = int(std::min<std::uint32_t>(cursor.u32(), 99));
            if (!numberType(variable.type)) cursor.fail(fmt::format("has a variable of the type {}", variable.type));
            cursor.skip(countBytes_);  // Its size, which follows from the others and may be too large for the field.
            variable.begin = cursor.whole(offsetBytes);
            if (!variables_.emplace(name, std::move(variable)).second)
                cursor.fail(fmt::format("has the variable '{}' twice", name));
        });
        measureRecords(streamed);
    }

    /// Each of a list's elements takes some bytes, so that its count is no more than there are.
    template <class Read>
    void readList(ByteCursor& cursor, std::uint32_t sign, const Read& read) const
    {
        const std::uint32_t found = cursor.u32();
        const std::uint64_t count = cursor.whole(countBytes_);
        if (found != sign && (found != 0 || count != 0)) cursor.fail("has a list that is none");
        for (std::uint64_t i = 0; i < count; ++i) read();
    }

    std::string readName(ByteCursor& cursor) const
    {
        const std::uint64_t length = cursor.whole(countBytes_);
        if (length > cursor.left()) cursor.fail("ends too early");
        std::string name = cursor.text(length);
        cursor.skip((4 - length % 4) % 4);
        return withoutControls(std::move(name), '?');
    }

    void readAttributes(ByteCursor& cursor, std::map<std::string, std::string>& texts) const
    {
        readList(cursor, kAttributes, [&] {
            const std::string name = readName(cursor);
            const auto type = int(std::min<std::uint32_t>(cursor.u32(), 99));
            const std::uint64_t count = cursor.whole(countBytes_);
            if (!numberType(type)) cursor.fail(fmt::format("has an attribute of the type {}", type));
            const std::uint64_t each = bytesOf(*numberType(type));
            if (count > cursor.left() / each) cursor.fail("ends too early");
            std::string text = cursor.text(count * each);
            cursor.skip((4 - text.size() % 4) % 4);
            text.erase(std::min(text.find('\0'), text.size()));
            if (type == kCharacters) texts[name] = text;
        });
    }

    /// Records of all variables that have any stand one after the other. Each variable's part is filled up to four
    /// bytes, unless there is one alone.
    void measureRecords(bool streamed)
    {
        std::uint64_t padded = 0, plain = 0, count = 0, begin = file_.size();
        for (auto& [name, variable] : variables_) {
            if (!variable.records) continue;
            plain = variable.perRecord() * variable.elementBytes();
            if (plain > file_.size() && records_ > 0)
                fail(fmt::format("a record of '{}' has {} bytes, and the file {}", name, plain, file_.size()),
                     "a complete, undamaged file");
            padded += plain + (4 - plain % 4) % 4;
            begin = std::min(begin, variable.begin);
            ++count;
        }
        recordBytes_ = count == 1 ? plain : padded;
        if (streamed) records_ = recordBytes_ == 0 ? 0 : (file_.size() - begin) / recordBytes_;
        for (auto& [name, length] : dimensions_)
            if (length == 0) length = records_;
        for (auto& [name, variable] : variables_)
            if (variable.records) variable.shape[0] = records_;
        requirePlaces();
    }

    /// Variables lie within the file, and not over each other.
    void requirePlaces() const
    {
        struct Place {
            std::uint64_t begin, end;
            const std::string* name;
        };
        std::vector<Place> places;
        for (const auto& [name, variable] : variables_) {
            const std::uint64_t count = variable.perRecord(), bytes = count * variable.elementBytes(),
                                before = variable.records && records_ > 0 ? records_ - 1 : 0;
            if (productOf(variable.shape) == 0) continue;
            if (variable.begin > file_.size() || bytes > file_.size() - variable.begin ||
                (before > 0 && before > (file_.size() - variable.begin - bytes) / recordBytes_))
                fail(fmt::format("the file is cut off: it has {} bytes", file_.size()),
                     fmt::format("{} elements of '{}' from {} on", fmt::join(variable.shape, " x "), name,
                                 variable.begin));
            places.push_back({variable.begin, variable.begin + bytes, &name});
        }
        std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.begin < b.begin; });
        for (std::size_t i = 1; i < places.size(); ++i)
            if (places[i].begin < places[i - 1].end)
                fail(fmt::format("'{}' begins within '{}'", *places[i].name, *places[i - 1].name),
                     "each behind the other");
    }

    const Variable& find(const std::string& variable) const
    {
        const auto found = variables_.find(variable);
        if (found == variables_.end()) fail(fmt::format("it has no variable '{}'", variable), "one");
        return found->second;
    }

    template <class Number>
    std::vector<Number> read(const std::string& name, const Slab& slab) const
    {
        const Variable& variable = find(name);
        if (!isWithin(slab, variable.shape))
            fail(fmt::format("'{}' has {} elements", name, fmt::join(variable.shape, " x ")),
                 "more, by what refers to them");
        const std::uint64_t count = productOf(slab.count), each = variable.elementBytes();
        if (count == 0) return {};
        if (count > file_.size() / each)
            fail(
                fmt::format("'{}' has {} elements of {} bytes, and the file {} bytes", name, count, each, file_.size()),
                "a complete, undamaged file");
        requireMemory(path(), fmt::format("reading '{}'", name), count * (sizeof(Number) + each));
        std::vector<Number> values(count);
        const std::uint64_t perRecord = variable.records ? variable.perRecord() : ~std::uint64_t{0};
        const std::uint64_t most = (1U << 20) / each;
        std::vector<std::uint8_t> buffer;
        forEachRun(wholeSlab(variable.shape), slab, [&](std::uint64_t source, std::uint64_t target, std::uint64_t run) {
            while (run > 0) {
                const std::uint64_t within = variable.records ? source % perRecord : source;
                const std::uint64_t record = variable.records ? source / perRecord : 0;
                const std::uint64_t n = std::min({run, most, perRecord - within});
                buffer.resize(n * each);
                if (variable.begin > file_.size()) file_.require(variable.begin, 1, name.c_str());
                file_.read(variable.begin + record * recordBytes_ + within * each, buffer.size(), buffer.data(),
                           name.c_str());
                convertNumbers<Number>(buffer.data(), *numberType(variable.type), true, {values.data() + target, n});
                source += n;
                target += n;
                run -= n;
            }
        });
        return values;
    }

    FileBytes file_;
    std::size_t countBytes_ = 4;
    std::uint64_t records_ = 0, recordBytes_ = 0;
    std::vector<std::pair<std::string, std::uint64_t>> dimensions_;
    std::map<std::string, Variable> variables_;
};

}  // namespace

std::unique_ptr<const NetcdfFile> openClassicNetcdf(const std::string& path)
{
    return std::make_unique<const ClassicNetcdf>(path);
}

}  // namespace aeolic
