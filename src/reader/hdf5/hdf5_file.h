#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reader/hdf5/hdf5_dataset.h"

namespace aeolic {

/// A group or a data set of an HDF5 file, by the HDF5 library. The file stays open as long as any object of it lives.
/// Links are followed, also into other files, which are looked for in the folder of the file that names them. Threads
/// may use objects at once. Every failure is an InputError that begins with the file's name.
class Hdf5Object {
public:
    /// The root of a file.
    static Hdf5Object openFile(const std::string& file);

    const std::string& file() const;  ///< That the object stands in, which a link may have led to.
    const std::string& name() const;  ///< "/VTKHDF/PointData": for messages.
    bool isDataSet() const;

    /// Two that are equal are the same object, by whatever name, as long as both live.
    std::pair<std::uint64_t, std::uint64_t> identity() const;

    /// Names of a group's objects, in the order in which they were made or, where the file does not say it, sorted.
    const std::vector<std::string>& names() const;
    bool has(const std::string& name) const;

    /// An object of a group: nothing where the group has no such name. The name may be a path. Throws where a link on
    /// the way leads nowhere.
    std::optional<Hdf5Object> find(const std::string& path) const;
    Hdf5Object require(const std::string& path) const;  ///< Throws where there is none.

    /// Whole numbers or reals of an attribute. Nothing where there is no such attribute, or it holds something else.
    std::optional<std::vector<std::int64_t>> wholeNumbers(const std::string& attribute) const;
    std::optional<std::vector<double>> reals(const std::string& attribute) const;
    std::optional<std::string> text(const std::string& attribute) const;

    /// The length of a data set in each dimension, slowest first; empty where it has a single element.
    const std::vector<std::uint64_t>& shape() const { return data().shape(); }
    std::uint64_t count() const { return data().count(); }  ///< Of its elements.
    /// Nothing where its elements are no numbers.
    std::optional<NumberType> type() const { return isDataSet() ? data().type() : std::nullopt; }

    /// Its elements, or a slab of them, as `Number`: float, double, std::int8_t, std::int32_t or std::int64_t. What was
    /// never written has the fill value.
    template <class Number>
    std::vector<Number> read(const Slab& slab) const
    {
        return data().read<Number>(slab);
    }
    template <class Number>
    std::vector<Number> read() const
    {
        return read<Number>(wholeSlab(shape()));
    }

    /// Its characters, of which each element is one.
    std::string characters() const { return data().characters(); }

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    struct State;
    explicit Hdf5Object(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    const Hdf5DataSet& data() const;
    /// `fault`: what the library said.
    [[noreturn]] void failAtLink(const std::string& link, const std::string& fault) const;

    std::shared_ptr<const State> state_;
};

}  // namespace aeolic
