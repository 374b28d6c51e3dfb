#include <cgns_io.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "aeolic/error.h"
#include "data/named_file.h"
#include "reader/binary/filled_text.h"
#include "reader/binary/slab.h"
#include "reader/cgns/cgns_node.h"
#include "reader/hdf5/hdf5_lock.h"

namespace aeolic {
namespace {

constexpr int kNameLength = CGIO_MAX_NAME_LENGTH + 1;
using Name = std::array<char, kNameLength>;

/// The library's file. It is for one thread at a time, as HDF5 is, which it calls for other files.
class AdfFile {
public:
    explicit AdfFile(const std::string& path) : path_(path)
    {
        bytes_ = checkReadableFile(path);
        const Hdf5Lock lock;
        cgio_error_abort(0);
        sound(cgio_open_file(path.c_str(), CGIO_MODE_READ, CGIO_FILE_ADF, &number_));
    }
    AdfFile(const AdfFile&) = delete;
    AdfFile& operator=(const AdfFile&) = delete;
    ~AdfFile()
    {
        const Hdf5Lock lock;
        if (number_ > 0) cgio_close_file(number_);
    }

    int number() const { return number_; }
    const std::string& path() const { return path_; }
    std::uint64_t bytes() const { return bytes_; }

    /// Throws what the library says of a call that failed.
    void sound(int status) const
    {
        if (status == CGIO_ERR_NONE) return;
        std::array<char, CGIO_MAX_ERROR_LENGTH + 1> message{};
        cgio_error_message(message.data());
        throw InputError(path_, fmt::format("it cannot be read as ADF ({})", withoutFilling(message.data())),
                         "a complete, undamaged file");
    }

private:
    std::string path_;
    std::uint64_t bytes_ = 0;
    int number_ = 0;
};

/// What ADF calls its kinds of numbers.
std::optional<NumberType> typeNamed(const std::string& name)
{
    static constexpr std::pair<const char*, NumberType> kTypes[] = {
        {"C1", NumberType::int8},    {"B1", NumberType::uint8},  {"I4", NumberType::int32},
        {"I8", NumberType::int64},   {"U4", NumberType::uint32}, {"U8", NumberType::uint64},
        {"R4", NumberType::float32}, {"R8", NumberType::float64}};
    for (const auto& [known, type] : kTypes)
        if (name == known) return type;
    return std::nullopt;
}

/// The text that `get`, a function of the library, tells of a node.
std::string adfText(const AdfFile& file, double id, int (*get)(int, double, char*))
{
    const Hdf5Lock lock;
    Name text{};
    file.sound(get(file.number(), id, text.data()));
    return withoutFilling(text.data());
}

class AdfNode final : public CgnsNode {
public:
    AdfNode(std::shared_ptr<const AdfFile> file, double id, std::string path, std::string name)
        : CgnsNode(file->path(), std::move(path), std::move(name), adfText(*file, id, cgio_get_label)),
          file_(std::move(file)),
          id_(id),
          type_(typeNamed(adfText(*file_, id, cgio_get_data_type)))
    {
        const Hdf5Lock lock;
        int rank = 0;
        std::array<cgsize_t, CGIO_MAX_DIMENSIONS> lengths{};
        file_->sound(cgio_get_dimensions(file_->number(), id_, &rank, lengths.data()));
        for (int i = 0; i < rank; ++i) shape_.push_back(std::uint64_t(std::max<cgsize_t>(lengths[std::size_t(i)], 0)));
    }

    std::vector<std::string> names() const override
    {
        const Hdf5Lock lock;
        int count = 0, found = 0;
        file_->sound(cgio_number_children(file_->number(), id_, &count));
        std::vector<char> texts(std::size_t(count) * kNameLength);
        if (count > 0)
            file_->sound(cgio_children_names(file_->number(), id_, 1, count, kNameLength, &found, texts.data()));
        std::vector<std::string> names;
        names.reserve(std::size_t(std::max(found, 0)));
        for (int i = 0; i < found; ++i) names.push_back(withoutFilling(texts.data() + std::size_t(i) * kNameLength));
        return names;
    }

    CgnsNodePtr child(const std::string& name) const override
    {
        const Hdf5Lock lock;
        double id = 0;
        if (name.size() > CGIO_MAX_NAME_LENGTH || cgio_get_node_id(file_->number(), id_, name.c_str(), &id) != 0)
            return nullptr;
        return std::make_shared<AdfNode>(file_, id, path() == "/" ? "/" + name : path() + "/" + name, name);
    }

    bool hasValue() const override { return type_ && !shape_.empty(); }
    std::optional<NumberType> type() const override { return hasValue() ? type_ : std::nullopt; }
    std::vector<std::uint64_t> shape() const override { return shape_; }

private:
    void readTo(const Target& target, const Places& first, const Places& count) const override
    {
        std::visit([&](auto* to) { readAs(first, count, *to); }, target);
    }

    template <class Number>
    void readAs(const Places& first, const Places& count, std::vector<Number>& to) const
    {
        if (!isWithin({first, count}, shape_))
            throw InputError(file(), fmt::format("'{}' has fewer numbers than are to be read", path()),
                             "a complete, undamaged file");
        // ADF packs nothing. So a file has all that its nodes claim to hold.
        std::uint64_t all = bytesOf(*type_);
        for (const std::uint64_t length : count)
            if (__builtin_mul_overflow(all, length, &all) || all > file_->bytes())
                throw InputError(file(), fmt::format("'{}' claims to hold more than the file", path()),
                                 "a complete, undamaged file");
        all /= bytesOf(*type_);
        to.resize(all);
        if (all == 0) return;
        std::vector<std::uint8_t> bytes(all * bytesOf(*type_));
        const std::vector<cgsize_t> ones(count.size(), 1), lengths(count.begin(), count.end());
        std::vector<cgsize_t> begin, end;
        for (std::size_t i = 0; i < count.size(); ++i) {
            begin.push_back(cgsize_t(first[i]) + 1);
            end.push_back(cgsize_t(first[i] + count[i]));
        }
        {
            const Hdf5Lock lock;
            file_->sound(cgio_read_data(file_->number(), id_, begin.data(), end.data(), ones.data(), int(count.size()),
                                        lengths.data(), ones.data(), lengths.data(), ones.data(), bytes.data()));
        }
        convertNumbers<Number>(bytes.data(), *type_, false, to);
    }

    std::shared_ptr<const AdfFile> file_;
    double id_;
    std::optional<NumberType> type_;
    std::vector<std::uint64_t> shape_;
};

}  // namespace

bool isAdf(const std::string& path)
{
    char start[32] = {};
    std::ifstream(path, std::ios::binary).read(start, sizeof start);
    return std::string(start, sizeof start).find("ADF Database") != std::string::npos;
}

CgnsNodePtr openAdfCgns(const std::string& path)
{
    const auto file = std::make_shared<const AdfFile>(path);
    double root = 0;
    const Hdf5Lock lock;
    file->sound(cgio_get_root_id(file->number(), &root));
    return std::make_shared<AdfNode>(file, root, "/", "/");
}

}  // namespace aeolic
