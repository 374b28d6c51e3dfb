#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reader/cgns/cgns_object.h"

namespace aeolic {

/// A node of a CGNS tree.
class CgnsNode {
public:
    /// The root. Throws InputError, which begins with the path, where the file is no CGNS file.
    static CgnsNode openFile(const std::string& path);

    const std::string& name() const { return name_; }
    const std::string& label() const { return object_->label(); }
    const std::string& file() const { return object_->file(); }

    /// The nodes in this one of a label, or of any where it is empty, in the file's order. Links are followed; those
    /// that lead nowhere are an InputError.
    std::vector<CgnsNode> children(const std::string& label = "") const;
    std::optional<CgnsNode> child(const std::string& name) const;
    std::optional<CgnsNode> childOf(const std::string& label) const;  ///< The first.

    bool hasValue() const { return object_->hasValue(); }
    std::optional<NumberType> type() const { return object_->type(); }
    /// The value's dimensions, fastest first, as CGNS says them.
    std::vector<std::uint64_t> shape() const { return object_->shape(); }
    std::string text() const;                  ///< Of the value; empty where it has none, or other numbers.
    std::vector<std::string> texts() const;    ///< Of a value of several texts of one length.
    std::vector<std::int64_t> wholes() const;  ///< Throws where the value is no whole numbers.
    std::vector<double> reals() const;
    template <class Number>
    std::vector<Number> read(const std::vector<std::uint64_t>& first, const std::vector<std::uint64_t>& count) const;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    CgnsNode(std::shared_ptr<const CgnsObject> object, std::string name);
    template <class Number>
    std::vector<Number> whole() const;

    std::shared_ptr<const CgnsObject> object_;
    std::string name_;
};

}  // namespace aeolic
