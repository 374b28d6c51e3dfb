#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "reader/binary/numbers.h"

namespace aeolic {

/// A node of a CGNS tree, in whichever form the file has it. Every failure is an InputError that begins with the file's
/// name.
class CgnsObject {
public:
    virtual ~CgnsObject() = default;

    virtual const std::string& file() const = 0;
    virtual const std::string& name() const = 0;  ///< "/Base/Zone": for messages.
    virtual const std::string& label() const = 0;

    virtual std::vector<std::string> names() const = 0;  ///< Of the nodes in it, in the file's order.
    /// Null where there is no such node. A link is what it leads to; throws where that is nowhere.
    virtual std::shared_ptr<const CgnsObject> child(const std::string& name) const = 0;

    virtual bool hasValue() const = 0;
    virtual std::optional<NumberType> type() const = 0;    ///< Of the value; nothing where it is no numbers.
    virtual std::vector<std::uint64_t> shape() const = 0;  ///< Of the value, fastest first, as CGNS says it.

    /// Where numbers go, and which kind they become.
    using Target =
        std::variant<std::vector<float>*, std::vector<double>*, std::vector<std::int64_t>*, std::vector<std::int8_t>*>;
    using Places = std::vector<std::uint64_t>;
    /// A block of the value, fastest first. Throws where it goes beyond the value. There is a value.
    virtual void read(const Places& first, const Places& count, const Target& target) const = 0;
};

/// The root of a CGNS file in HDF5, or in ADF, the form of files before. Throws InputError.
std::shared_ptr<const CgnsObject> openHdf5Cgns(const std::string& path);
std::shared_ptr<const CgnsObject> openAdfCgns(const std::string& path);

/// Whether a file is in ADF, by how it begins.
bool isAdf(const std::string& path);

}  // namespace aeolic
