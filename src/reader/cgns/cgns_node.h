#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reader/binary/numbers.h"

namespace aeolic {

class CgnsNode;
using CgnsNodePtr = std::shared_ptr<const CgnsNode>;

/// A node of a CGNS tree, in whichever form the file has it. Every failure is an InputError that begins with the file's
/// name.
class CgnsNode {
public:
    /// `path`: "/Base/Zone", for messages. `name`: what the node above calls it.
    CgnsNode(std::string file, std::string path, std::string name, std::string label)
        : file_(std::move(file)), path_(std::move(path)), name_(std::move(name)), label_(std::move(label))
    {
    }
    virtual ~CgnsNode() = default;

    const std::string& file() const { return file_; }
    const std::string& path() const { return path_; }
    const std::string& name() const { return name_; }
    const std::string& label() const { return label_; }

    virtual std::vector<std::string> names() const = 0;  ///< The names of the nodes in it, in the file's order.
    /// The node of that name in it; null where there is none. A link is what it leads to; throws where that is nowhere.
    virtual CgnsNodePtr child(const std::string& name) const = 0;
    /// The nodes in it that have the label, in the file's order.
    std::vector<CgnsNodePtr> children(const std::string& label) const;
    /// The first node in it that has the label; null where there is none.
    CgnsNodePtr childOf(const std::string& label) const;

    virtual bool hasValue() const = 0;
    virtual std::optional<NumberType> type()
        const = 0;  ///< The type of the value's numbers; nothing where it has none.
    virtual std::vector<std::uint64_t> shape() const = 0;  ///< The value's lengths, fastest first, as CGNS says them.
    std::string text() const;                              ///< The value as a text; empty where it is no text.
    std::vector<std::string> texts() const;                ///< The value as several texts of one length.
    std::vector<std::int64_t> wholes() const;              ///< Throws where the value is no whole numbers.

    using Places = std::vector<std::uint64_t>;
    /// A block of the value, fastest first, or all of it, as `Number`: float, double, std::int64_t or std::int8_t.
    /// Throws where the block goes beyond the value.
    template <class Number>
    std::vector<Number> read(const Places& first, const Places& count) const
    {
        if (!hasValue()) fail("it holds nothing", "numbers");
        std::vector<Number> values;
        readTo(&values, first, count);
        return values;
    }
    template <class Number>
    std::vector<Number> read() const
    {
        const Places count = shape();
        return read<Number>(Places(count.size(), 0), count);
    }

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

protected:
    /// The list that numbers are read into. Its type is the kind that they become.
    using Target =
        std::variant<std::vector<float>*, std::vector<double>*, std::vector<std::int64_t>*, std::vector<std::int8_t>*>;
    virtual void readTo(const Target& target, const Places& first,
                        const Places& count) const = 0;  ///< Reads a part of the node's value.

private:
    std::string file_, path_, name_, label_;
};

/// The root of a CGNS file. Throws InputError, which begins with the path, where the file is no CGNS file.
CgnsNodePtr openCgnsTree(const std::string& path);

/// The root of a CGNS file in HDF5, or in ADF, the form of older files. Throws InputError.
CgnsNodePtr openHdf5Cgns(const std::string& path);
CgnsNodePtr openAdfCgns(const std::string& path);

/// Whether a file is in ADF, by how it begins.
bool isAdf(const std::string& path);

}  // namespace aeolic
