#include "reader/cgns/cgns_node.h"

#include <fmt/format.h>

#include "aeolic/error.h"
#include "reader/binary/filled_text.h"

namespace aeolic {

CgnsNodePtr openCgnsTree(const std::string& path)
{
    const bool inAdf = isAdf(path);
    auto root = inAdf ? openAdfCgns(path) : openHdf5Cgns(path);
    if (!root->childOf("CGNSBase_t") && !root->child("CGNSLibraryVersion"))
        throw InputError(path, fmt::format("it is an {} file, but not one of CGNS", inAdf ? "ADF" : "HDF5"),
                         "a CGNS file");
    return root;
}

std::vector<CgnsNodePtr> CgnsNode::children(const std::string& label) const
{
    std::vector<CgnsNodePtr> nodes;
    for (const std::string& name : names()) {
        auto node = child(name);
        if (node && node->label() == label) nodes.push_back(std::move(node));
    }
    return nodes;
}

CgnsNodePtr CgnsNode::childOf(const std::string& label) const
{
    const std::vector<CgnsNodePtr> all = children(label);
    return all.empty() ? nullptr : all.front();
}

std::string CgnsNode::text() const
{
    const auto kind = type();
    if (!kind || bytesOf(*kind) != 1) return "";
    const auto characters = read<std::int8_t>();
    return withoutFilling({characters.begin(), characters.end()});
}

std::vector<std::string> CgnsNode::texts() const
{
    const auto kind = type();
    if (!kind || bytesOf(*kind) != 1) fail("it holds no text", "text");
    const auto characters = read<std::int8_t>();
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
    const auto kind = type();
    if (!kind || *kind >= NumberType::float32) fail("it holds no whole numbers", "whole numbers");
    return read<std::int64_t>();
}

void CgnsNode::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(file(), fmt::format("'{}': {}", path(), found), expected);
}

}  // namespace aeolic
