#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reader/hdf5/hdf5_file.h"

namespace aeolic {

/// The files that a CGNS tree stands in: links lead from one to others.
class CgnsFiles {
public:
    /// The root of the file `named`, which a link in the file `from` names.
    Hdf5Object open(const std::string& named, const std::string& from);

private:
    std::map<std::string, Hdf5Object> open_;
};

/// A node of a CGNS tree, as CGNS lays it out in HDF5: a group with a label, whose value is the data set " data".
class CgnsNode {
public:
    /// The root. Throws InputError, which begins with the path, where the file is no CGNS file in HDF5.
    static CgnsNode openFile(const std::string& path);

    const std::string& name() const { return name_; }
    const std::string& label() const { return label_; }
    const std::string& file() const { return object_.file(); }

    /// The nodes in this one of a label, or of any where it is empty, in the file's order. Links are followed; those
    /// that lead nowhere are an InputError.
    std::vector<CgnsNode> children(const std::string& label = "") const;
    std::optional<CgnsNode> child(const std::string& name) const;
    std::optional<CgnsNode> childOf(const std::string& label) const;  ///< The first.

    bool hasValue() const { return value().has_value(); }
    std::optional<NumberType> type() const;
    /// The value's dimensions, fastest first, as CGNS says them.
    std::vector<std::uint64_t> shape() const;
    std::string text() const;                  ///< Of the value; empty where it has none, or other numbers.
    std::vector<std::string> texts() const;    ///< Of a value of several texts of one length.
    std::vector<std::int64_t> wholes() const;  ///< Throws where the value is no whole numbers.
    std::vector<double> reals() const;
    template <class Number>
    std::vector<Number> read(std::vector<std::uint64_t> first, std::vector<std::uint64_t> count) const;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    CgnsNode(std::shared_ptr<CgnsFiles> files, Hdf5Object object, std::string name);
    std::optional<Hdf5Object> value() const;
    std::optional<CgnsNode> target() const;

    std::shared_ptr<CgnsFiles> files_;
    Hdf5Object object_;
    std::string name_, label_;
};

}  // namespace aeolic
