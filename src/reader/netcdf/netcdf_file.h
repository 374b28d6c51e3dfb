#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reader/binary/numbers.h"
#include "reader/binary/slab.h"
#include "reader/hdf5/hdf5_file.h"

namespace aeolic {

/// A netCDF file in any form that the netCDF library knows: the classic ones (CDF-1, CDF-2 with 64-bit offsets, CDF-5)
/// and netCDF-4, which is HDF5. Every failure is an InputError that begins with the file's name.
class NetcdfFile {
public:
    explicit NetcdfFile(const std::string& path);
    ~NetcdfFile();
    NetcdfFile(const NetcdfFile&) = delete;
    NetcdfFile& operator=(const NetcdfFile&) = delete;

    const std::string& path() const { return path_; }

    /// How long a dimension is; of that without limit, how long it has become.
    std::optional<std::uint64_t> dimension(const std::string& name) const;

    bool has(const std::string& variable) const { return variables_.contains(variable); }
    std::vector<std::string> variables() const;  ///< Their names, sorted.

    /// Slowest first. In netCDF-4 a variable is only as long as it was written. What follows throws where there is no
    /// such variable.
    std::vector<std::uint64_t> shape(const std::string& variable) const;
    const std::vector<std::string>& dimensions(const std::string& variable) const;  ///< Their names.
    std::optional<NumberType> type(const std::string& variable) const;              ///< Nothing of characters.
    std::optional<std::string> text(const std::string& variable, const std::string& attribute) const;
    std::optional<std::vector<double>> numbers(const std::string& variable, const std::string& attribute) const;

    /// A slab of a variable's numbers, as float, double or std::int64_t.
    template <class Number>
    std::vector<Number> read(const std::string& variable, const Slab& slab) const;
    template <class Number>
    std::vector<Number> read(const std::string& variable) const
    {
        return read<Number>(variable, wholeSlab(shape(variable)));
    }

    /// The rows of a variable of characters as texts, without what fills them up.
    std::vector<std::string> texts(const std::string& variable) const;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    struct Variable {
        int id, type;
        std::vector<std::uint64_t> shape;
        std::vector<std::string> dimensions;
        mutable std::optional<Hdf5Object> object = {};  // Once it was asked for.
    };

    bool readHeader(std::uint64_t fileBytes);
    const Variable& find(const std::string& variable) const;
    const Hdf5Object& object(const std::string& variable) const;
    void sound(int status, const std::string& what) const;

    std::string path_;
    int id_ = -1;                     // The library's.
    std::optional<Hdf5Object> root_;  // Of netCDF-4. Then the library has closed the file.
    std::map<std::string, std::uint64_t> dimensions_;
    std::map<std::string, Variable> variables_;
};

}  // namespace aeolic
