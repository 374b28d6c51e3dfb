#include "reader/cgns/cgns_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "aeolic/error.h"
#include "reader/binary/filled_text.h"

namespace aeolic {
namespace {

constexpr char kData[] = " data";

bool beginsLikeAdf(const std::string& path)
{
    char start[32] = {};
    std::ifstream(path, std::ios::binary).read(start, sizeof start);
    return std::string(start, sizeof start).find("ADF Database") != std::string::npos;
}

}  // namespace

Hdf5Object CgnsFiles::open(const std::string& named, const std::string& from)
{
    const std::string path = (std::filesystem::path(from).parent_path() / named).string();
    const auto known = open_.find(path);
    if (known != open_.end()) return known->second;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw InputError(from, fmt::format("its link to '{}' leads nowhere", withoutFilling(named)),
                         "a CGNS file of that name beside it");
    return open_.emplace(path, Hdf5Object::openFile(path)).first->second;
}

CgnsNode::CgnsNode(std::shared_ptr<CgnsFiles> files, Hdf5Object object, std::string name)
    : files_(std::move(files)),
      object_(std::move(object)),
      name_(std::move(name)),
      label_(object_.text("label").value_or(""))
{
}

CgnsNode CgnsNode::openFile(const std::string& path)
{
    if (beginsLikeAdf(path))
        throw InputError(path, "it is a CGNS file in the old form ADF",
                         "CGNS in HDF5 (cgnsconvert -h FILE NEW writes it so)");
    auto root = CgnsNode(std::make_shared<CgnsFiles>(), Hdf5Object::openFile(path), "/");
    if (!root.childOf("CGNSBase_t") && !root.child("CGNSLibraryVersion"))
        throw InputError(path, "it is an HDF5 file, but not one of CGNS", "a CGNS file");
    return root;
}

std::optional<CgnsNode> CgnsNode::child(const std::string& name) const
{
    const auto found = object_.find(name);
    if (!found || found->isDataSet()) return std::nullopt;
    CgnsNode node(files_, *found, name);
    if (found->text("type") != "LK") return node;
    return node.target();
}

/// What a link stands for. It says so in two data sets; the file is this one where none is named.
std::optional<CgnsNode> CgnsNode::target() const
{
    const auto textOf = [&](const char* name) -> std::string {
        const auto data = object_.find(name);
        if (!data || !data->isDataSet()) return "";
        const auto characters = data->read<std::int8_t>();
        std::string text(characters.begin(), characters.end());
        return text.erase(std::min(text.find('\0'), text.size()));
    };
    const std::string path = textOf(" path"), named = textOf(" file");
    if (path.empty()) fail("its link leads nowhere", "a path to a node");
    std::optional<CgnsNode> at;
    at.emplace(CgnsNode(files_, named.empty() ? object_.require("/") : files_->open(named, file()), name_));
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        if (end > begin) at = at->child(path.substr(begin, end - begin));
        if (!at)
            fail(fmt::format("its link leads to '{}', which is not in {}", withoutFilling(path),
                             named.empty() ? "the file" : withoutFilling(named)),
                 "a path to a node");
        begin = end + 1;
    }
    at->name_ = name_;
    return at;
}

std::vector<CgnsNode> CgnsNode::children(const std::string& label) const
{
    std::vector<CgnsNode> nodes;
    for (const std::string& name : object_.names()) {
        if (name.starts_with(' ')) continue;  // What CGNS keeps for itself.
        auto node = child(name);
        if (node && (label.empty() || node->label_ == label)) nodes.push_back(std::move(*node));
    }
    return nodes;
}

std::optional<CgnsNode> CgnsNode::childOf(const std::string& label) const
{
    for (CgnsNode& node : children(label)) return std::move(node);
    return std::nullopt;
}

std::optional<Hdf5Object> CgnsNode::value() const
{
    auto data = object_.find(kData);
    if (data && !data->isDataSet()) return std::nullopt;
    return data;
}

std::optional<NumberType> CgnsNode::type() const
{
    const auto data = value();
    return data ? data->type() : std::nullopt;
}

std::vector<std::uint64_t> CgnsNode::shape() const
{
    const auto data = value();
    if (!data) return {};
    return {data->shape().rbegin(), data->shape().rend()};
}

std::string CgnsNode::text() const
{
    const auto data = value();
    if (!data || !data->type() || bytesOf(*data->type()) != 1) return "";
    const auto characters = data->read<std::int8_t>();
    return withoutFilling({characters.begin(), characters.end()});
}

std::vector<std::string> CgnsNode::texts() const
{
    const auto data = value();
    if (!data || !data->type() || bytesOf(*data->type()) != 1) fail("it holds no text", "text");
    const auto characters = data->read<std::int8_t>();
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
    const auto data = value();
    if (!data || !data->type() || isReal(*data->type())) fail("it holds no whole numbers", "whole numbers");
    return data->read<std::int64_t>();
}

std::vector<double> CgnsNode::reals() const
{
    const auto data = value();
    if (!data) fail("it holds nothing", "numbers");
    return data->read<double>();
}

template <class Number>
std::vector<Number> CgnsNode::read(std::vector<std::uint64_t> first, std::vector<std::uint64_t> count) const
{
    const auto data = value();
    if (!data) fail("it holds nothing", "numbers");
    std::reverse(first.begin(), first.end());
    std::reverse(count.begin(), count.end());
    return data->read<Number>({std::move(first), std::move(count)});
}

void CgnsNode::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(file(), fmt::format("'{}': {}", object_.name(), found), expected);
}

template std::vector<float> CgnsNode::read(std::vector<std::uint64_t>, std::vector<std::uint64_t>) const;
template std::vector<double> CgnsNode::read(std::vector<std::uint64_t>, std::vector<std::uint64_t>) const;
template std::vector<std::int64_t> CgnsNode::read(std::vector<std::uint64_t>, std::vector<std::uint64_t>) const;

}  // namespace aeolic
