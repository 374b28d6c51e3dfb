#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/binary/numbers.h"
#include "data/binary/slab.h"

namespace aeolic {

class Hdf5Store;

/// A group or a data set of an HDF5 file, which stays open as long as any object of it lives. Links to other files are
/// not followed here. Nothing in the file is believed: every failure is an InputError that begins with its name.
class Hdf5Object {
public:
    /// The root of a file.
    static Hdf5Object openFile(const std::string& file);

    const std::string& file() const;
    const std::string& name() const;  ///< "/VTKHDF/PointData": for messages.
    bool isDataSet() const;

    /// Names of a group's objects, in the order in which they were made or, where the file does not say it, sorted.
    const std::vector<std::string>& names() const;
    bool has(const std::string& name) const;

    /// An object of a group: nothing where there is none of that name, or the link leads to another file. The name may
    /// be a path; soft links are followed.
    std::optional<Hdf5Object> find(const std::string& path) const;
    Hdf5Object require(const std::string& path) const;  ///< Throws where there is none.

    /// Whole numbers or reals of an attribute. Nothing where there is no such attribute, or it holds something else.
    std::optional<std::vector<std::int64_t>> wholeNumbers(const std::string& attribute) const;
    std::optional<std::vector<double>> reals(const std::string& attribute) const;
    std::optional<std::string> text(const std::string& attribute) const;

    /// The length of a data set in each dimension, slowest first; empty where it has a single element.
    const std::vector<std::uint64_t>& shape() const;
    std::uint64_t count() const;             ///< Of its elements.
    std::optional<NumberType> type() const;  ///< Nothing where its elements are no numbers.

    /// Its elements, or a slab of them, as `Number`: float, double, std::int8_t, std::int32_t or std::int64_t. What was
    /// never written has the fill value. Memory is taken only for what the file can hold.
    template <class Number>
    std::vector<Number> read() const;
    template <class Number>
    std::vector<Number> read(const Slab& slab) const;

    /// Its texts.
    std::vector<std::string> texts() const;

    /// Its elements as they stand in the file.
    std::vector<std::uint8_t> bytes() const;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    struct State;
    explicit Hdf5Object(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    /// `followed`: the links of this lookup so far.
    std::optional<Hdf5Object> follow(const std::string& path, int& followed) const;

    std::shared_ptr<const State> state_;
};

}  // namespace aeolic
