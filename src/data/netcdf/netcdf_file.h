#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/binary/numbers.h"
#include "data/binary/slab.h"

namespace aeolic {

/// A netCDF file in any of its forms: the classic ones (CDF-1, CDF-2 with 64-bit offsets, CDF-5) and netCDF-4, which is
/// HDF5. Nothing in the file is believed: every failure is an InputError that begins with its name.
class NetcdfFile {
public:
    static std::unique_ptr<const NetcdfFile> open(const std::string& path);
    virtual ~NetcdfFile() = default;

    const std::string& path() const { return path_; }

    /// How long a dimension is; of that without limit, how long it has become.
    virtual std::optional<std::uint64_t> dimension(const std::string& name) const = 0;

    virtual std::size_t variableCount() const = 0;
    virtual bool has(const std::string& variable) const = 0;

    /// Slowest first. What follows throws where there is no such variable.
    virtual std::vector<std::uint64_t> shape(const std::string& variable) const = 0;
    virtual std::optional<NumberType> type(const std::string& variable) const = 0;  ///< Nothing of characters.
    virtual std::optional<std::string> text(const std::string& variable, const std::string& attribute) const = 0;

    /// A slab of a variable's numbers. Memory is taken only for what the file can hold.
    virtual std::vector<float> floats(const std::string& variable, const Slab& slab) const = 0;
    virtual std::vector<double> doubles(const std::string& variable, const Slab& slab) const = 0;
    virtual std::vector<std::int64_t> wholes(const std::string& variable, const Slab& slab) const = 0;

    std::vector<double> doubles(const std::string& variable) const
    {
        return doubles(variable, wholeSlab(shape(variable)));
    }
    std::vector<std::int64_t> wholes(const std::string& variable) const
    {
        return wholes(variable, wholeSlab(shape(variable)));
    }

    /// The rows of a variable of characters as texts, without what fills them up.
    std::vector<std::string> texts(const std::string& variable) const;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

protected:
    explicit NetcdfFile(const std::string& path) : path_(path) {}
    virtual std::vector<std::uint8_t> characters(const std::string& variable) const = 0;

private:
    std::string path_;
};

std::unique_ptr<const NetcdfFile> openClassicNetcdf(const std::string& path);
std::unique_ptr<const NetcdfFile> openNetcdf4(const std::string& path);

}  // namespace aeolic
