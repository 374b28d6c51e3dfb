#include "reader/cgns/cgns_tree.h"

#include <fmt/format.h>

#include <utility>

#include "aeolic/error.h"
#include "reader/binary/filled_text.h"

namespace aeolic {

CgnsNode::CgnsNode(std::shared_ptr<const CgnsObject> object, std::string name)
    : object_(std::move(object)), name_(std::move(name))
{
}

CgnsNode CgnsNode::openFile(const std::string& path)
{
    const bool inAdf = isAdf(path);
    auto root = CgnsNode(inAdf ? openAdfCgns(path) : openHdf5Cgns(path), "/");
    if (!root.childOf("CGNSBase_t") && !root.child("CGNSLibraryVersion"))
        throw InputError(path, fmt::format("it is an {} file, but not one of CGNS", inAdf ? "ADF" : "HDF5"),
                         "a CGNS file");
    return root;
}

std::optional<CgnsNode> CgnsNode::child(const std::string& name) const
{
    auto found = object_->child(name);
    if (!found) return std::nullopt;
    return CgnsNode(std::move(found), name);
}

std::vector<CgnsNode> CgnsNode::children(const std::string& label) const
{
    std::vector<CgnsNode> nodes;
    for (const std::string& name : object_->names()) {
        auto node = child(name);
        if (node && (label.empty() || node->label() == label)) nodes.push_back(std::move(*node));
    }
    return nodes;
}

std::optional<CgnsNode> CgnsNode::childOf(const std::string& label) const
{
    for (CgnsNode& node : children(label)) return std::move(node);
    return std::nullopt;
}

template <class Number>
std::vector<Number> CgnsNode::whole() const
{
    const std::vector<std::uint64_t> count = shape(), first(count.size(), 0);
    std::vector<Number> values;
    object_->read(first, count, &values);
    return values;
}

std::string CgnsNode::text() const
{
    if (!type() || bytesOf(*type()) != 1) return "";
    const auto characters = whole<std::int8_t>();
    return withoutFilling({characters.begin(), characters.end()});
}

std::vector<std::string> CgnsNode::texts() const
{
    if (!type() || bytesOf(*type()) != 1) fail("it holds no text", "text");
    const auto characters = whole<std::int8_t>();
    const auto lengths = shape();
    const std::uint64_t length = lengths.empty() ? characters.size() : lengths[0];
    std::vector<std::string> all;
    for (std::uint64_t at = 0; length > 0 && at + length <= characters.size(); at += length)
        all.push_back(withoutFilling(
            {characters.begin() + std::ptrdiff_t(at), characters.begin() + std::ptrdiff_t(at + length)}));
    return all;
}

std::vector<std::int64_t> CgnsNode::wholes() const
{
    if (!type() || isReal(*type())) fail("it holds no whole numbers", "whole numbers");
    return whole<std::int64_t>();
}

std::vector<double> CgnsNode::reals() const
{
    if (!hasValue()) fail("it holds nothing", "numbers");
    return whole<double>();
}

template <class Number>
std::vector<Number> CgnsNode::read(const std::vector<std::uint64_t>& first,
                                   const std::vector<std::uint64_t>& count) const
{
    if (!hasValue()) fail("it holds nothing", "numbers");
    std::vector<Number> values;
    object_->read(first, count, &values);
    return values;
}

void CgnsNode::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(file(), fmt::format("'{}': {}", object_->name(), found), expected);
}

template std::vector<float> CgnsNode::read(const std::vector<std::uint64_t>&, const std::vector<std::uint64_t>&) const;
template std::vector<double> CgnsNode::read(const std::vector<std::uint64_t>&, const std::vector<std::uint64_t>&) const;
template std::vector<std::int64_t> CgnsNode::read(const std::vector<std::uint64_t>&,
                                                  const std::vector<std::uint64_t>&) const;

}  // namespace aeolic
