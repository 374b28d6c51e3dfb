#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "aeolic/error.h"
#include "reader/binary/filled_text.h"
#include "reader/cgns/cgns_node.h"
#include "reader/hdf5/hdf5_file.h"

namespace aeolic {
namespace {

constexpr char kData[] = " data", kPath[] = "a path to a node";

/// The files that a CGNS tree stands in: links lead from one to others.
class Files {
public:
    /// The root of the file `named`, which a link in the file `from` names.
    Hdf5Object open(const std::string& named, const std::string& from)
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

private:
    std::map<std::string, Hdf5Object> open_;
};

/// A node of a CGNS file in HDF5. It is a group with a label, and its value is the data set " data".
class Hdf5Node final : public CgnsNode {
public:
    Hdf5Node(std::shared_ptr<Files> files, const Hdf5Object& object, std::string name)
        : CgnsNode(object.file(), object.name(), std::move(name), object.text("label").value_or("")),
          files_(std::move(files)),
          object_(object)
    {
    }

    std::vector<std::string> names() const override
    {
        std::vector<std::string> names = object_.names();
        std::erase_if(names, [](const std::string& name) { return name.starts_with(' '); });  // CGNS's own.
        return names;
    }

    CgnsNodePtr child(const std::string& name) const override { return find(name); }

    bool hasValue() const override { return value().has_value(); }
    std::optional<NumberType> type() const override
    {
        const auto data = value();
        return data ? data->type() : std::nullopt;
    }
    std::vector<std::uint64_t> shape() const override
    {
        const auto data = value();
        if (!data) return {};
        return {data->shape().rbegin(), data->shape().rend()};
    }

private:
    void readTo(const Target& target, const Places& first, const Places& count) const override
    {
        const Slab slab{{first.rbegin(), first.rend()}, {count.rbegin(), count.rend()}};
        const Hdf5Object data = *value();
        std::visit([&]<class Number>(std::vector<Number>* to) { *to = data.read<Number>(slab); }, target);
    }

    std::optional<Hdf5Object> value() const
    {
        auto data = object_.find(kData);
        if (data && !data->isDataSet()) return std::nullopt;
        return data;
    }

    std::shared_ptr<const Hdf5Node> find(const std::string& name) const
    {
        const auto found = object_.find(name);
        if (!found || found->isDataSet()) return nullptr;
        const auto node = std::make_shared<const Hdf5Node>(files_, *found, name);
        return found->text("type") == "LK" ? node->target() : node;
    }

    /// What a link stands for. It says so in two data sets; the file is this one where none is named.
    std::shared_ptr<const Hdf5Node> target() const
    {
        const auto textOf = [&](const char* name) -> std::string {
            const auto data = object_.find(name);
            if (!data || !data->isDataSet()) return "";
            const auto characters = data->read<std::int8_t>();
            std::string text(characters.begin(), characters.end());
            return text.erase(std::min(text.find('\0'), text.size()));
        };
        const std::string path = textOf(" path"), named = textOf(" file");
        if (path.empty()) fail("its link leads nowhere", kPath);
        auto at = std::make_shared<const Hdf5Node>(
            files_, named.empty() ? object_.require("/") : files_->open(named, file()), "/");
        for (std::size_t begin = 0; begin < path.size();) {
            const std::size_t end = std::min(path.find('/', begin), path.size());
            if (end > begin) at = at->find(path.substr(begin, end - begin));
            if (!at)
                fail(fmt::format("its link leads to '{}', which is not in {}", withoutFilling(path),
                                 named.empty() ? "the file" : withoutFilling(named)),
                     kPath);
            begin = end + 1;
        }
        return std::make_shared<const Hdf5Node>(files_, at->object_, name());
    }

    std::shared_ptr<Files> files_;
    Hdf5Object object_;
};

}  // namespace

CgnsNodePtr openHdf5Cgns(const std::string& path)
{
    return std::make_shared<Hdf5Node>(std::make_shared<Files>(), Hdf5Object::openFile(path), "/");
}

}  // namespace aeolic
