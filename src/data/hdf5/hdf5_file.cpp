#include "data/hdf5/hdf5_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/hdf5/hdf5_dataset.h"
#include "data/hdf5/hdf5_links.h"

namespace aeolic {

struct Hdf5Object::State {
    std::shared_ptr<const Hdf5Store> store;
    std::shared_ptr<const State> root;  // Null of the root itself.
    std::string name;
    std::vector<Hdf5Message> header;
    std::vector<Hdf5Link> links;
    std::vector<std::string> names;                     // Those of the links.
    std::vector<std::vector<std::uint8_t>> attributes;  // As they stand in the file.
    std::optional<Hdf5DataSet> data;

    State(std::shared_ptr<const Hdf5Store> from, std::shared_ptr<const State> top, std::string called,
          std::uint64_t address)
        : store(std::move(from)), root(std::move(top)), name(std::move(called)), header(readHdf5Header(*store, address))
    {
        attributes = readHdf5Attributes(*store, header);
        if (findMessage(header, Hdf5MessageKind::layout)) {
            data.emplace(*store, header, name);
            return;
        }
        links = readHdf5Links(*store, header);
        for (const Hdf5Link& link : links) names.push_back(link.name);
    }
    State(const State&) = delete;  // `data` refers to it.

    std::optional<Hdf5Attribute> attribute(const std::string& wanted) const
    {
        for (const auto& message : attributes)
            if (auto found = parseHdf5Attribute(*store, message, wanted)) return found;
        return std::nullopt;
    }

    template <class Number>
    std::optional<std::vector<Number>> numbers(const std::string& wanted) const
    {
        const auto found = attribute(wanted);
        if (!found || found->type.kind != Hdf5Type::Kind::number) return std::nullopt;
        std::vector<Number> values(found->space.count());
        convertNumbers<Number>(found->data.data(), found->type.number, found->type.swapped, values);
        return values;
    }
};

namespace {

constexpr int kMostLinks = 16;  // Of one lookup in all: one may lead to a path of many others.

}  // namespace

Hdf5Object Hdf5Object::openFile(const std::string& file)
{
    auto store = std::make_shared<const Hdf5Store>(file);
    const std::uint64_t address = store->rootAddress();
    return Hdf5Object(std::make_shared<const State>(std::move(store), nullptr, "/", address));
}

const std::string& Hdf5Object::file() const
{
    return state_->store->path();
}

const std::string& Hdf5Object::name() const
{
    return state_->name;
}

bool Hdf5Object::isDataSet() const
{
    return state_->data.has_value();
}

const std::vector<std::string>& Hdf5Object::names() const
{
    return state_->names;
}

bool Hdf5Object::has(const std::string& name) const
{
    return std::find(state_->names.begin(), state_->names.end(), name) != state_->names.end();
}

std::optional<Hdf5Object> Hdf5Object::find(const std::string& path) const
{
    int followed = 0;
    return follow(path, followed);
}

std::optional<Hdf5Object> Hdf5Object::follow(const std::string& path, int& followed) const
{
    Hdf5Object at = *this;
    if (path.starts_with('/') && state_->root) at = Hdf5Object(state_->root);
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string name = path.substr(begin, end - begin);
        begin = end + 1;
        if (name.empty() || name == ".") continue;
        const State& state = *at.state_;
        const auto link = std::find_if(state.links.begin(), state.links.end(),
                                       [&](const Hdf5Link& each) { return each.name == name; });
        if (link == state.links.end() || !link->file.empty()) return std::nullopt;
        if (!link->target.empty()) {
            if (++followed > kMostLinks) fail("its links lead on for ever", "links to objects");
            const auto found = at.follow(link->target, followed);
            if (!found) return std::nullopt;
            at = *found;
            continue;
        }
        const std::string called = (state.name == "/" ? "" : state.name) + "/" + name;
        at = Hdf5Object(
            std::make_shared<const State>(state.store, state.root ? state.root : at.state_, called, link->address));
    }
    return at;
}

Hdf5Object Hdf5Object::require(const std::string& path) const
{
    const auto found = find(path);
    if (!found) fail(fmt::format("it has no '{}'", path), "one");
    return *found;
}

std::optional<std::vector<std::int64_t>> Hdf5Object::wholeNumbers(const std::string& attribute) const
{
    const auto found = state_->attribute(attribute);
    if (found && found->type.kind == Hdf5Type::Kind::number && isReal(found->type.number)) return std::nullopt;
    return state_->numbers<std::int64_t>(attribute);
}

std::optional<std::vector<double>> Hdf5Object::reals(const std::string& attribute) const
{
    return state_->numbers<double>(attribute);
}

std::optional<std::string> Hdf5Object::text(const std::string& attribute) const
{
    const auto found = state_->attribute(attribute);
    if (!found || found->space.count() == 0) return std::nullopt;
    if (found->type.kind != Hdf5Type::Kind::text && found->type.kind != Hdf5Type::Kind::variableText)
        return std::nullopt;
    return hdf5Texts(*state_->store, found->type, 1, found->data).front();
}

const std::vector<std::uint64_t>& Hdf5Object::shape() const
{
    if (!isDataSet()) fail("it is a group", "numbers");
    return state_->data->space().shape;
}

std::uint64_t Hdf5Object::count() const
{
    if (!isDataSet()) fail("it is a group", "numbers");
    return state_->data->space().count();
}

std::optional<NumberType> Hdf5Object::type() const
{
    if (!isDataSet() || state_->data->type().kind != Hdf5Type::Kind::number) return std::nullopt;
    return state_->data->type().number;
}

template <class Number>
std::vector<Number> Hdf5Object::read() const
{
    return read<Number>(wholeSlab(shape()));
}

template <class Number>
std::vector<Number> Hdf5Object::read(const Slab& slab) const
{
    if (!isDataSet()) fail("it is a group", "numbers");
    return state_->data->read<Number>(slab);
}

std::vector<std::string> Hdf5Object::texts() const
{
    if (!isDataSet()) fail("it is a group", "texts");
    const Hdf5DataSet& data = *state_->data;
    if (data.type().kind != Hdf5Type::Kind::text && data.type().kind != Hdf5Type::Kind::variableText)
        fail(fmt::format("its elements are of the kind {}", data.type().name), "texts");
    return hdf5Texts(*state_->store, data.type(), data.space().count(), data.bytes());
}

std::vector<std::uint8_t> Hdf5Object::bytes() const
{
    if (!isDataSet()) fail("it is a group", "numbers or texts");
    return state_->data->bytes();
}

void Hdf5Object::fail(const std::string& found, const std::string& expected) const
{
    state_->store->fail(fmt::format("'{}': {}", name(), found), expected);
}

template std::vector<float> Hdf5Object::read() const;
template std::vector<double> Hdf5Object::read() const;
template std::vector<std::int8_t> Hdf5Object::read() const;
template std::vector<std::int32_t> Hdf5Object::read() const;
template std::vector<std::int64_t> Hdf5Object::read() const;
template std::vector<float> Hdf5Object::read(const Slab&) const;
template std::vector<double> Hdf5Object::read(const Slab&) const;
template std::vector<std::int8_t> Hdf5Object::read(const Slab&) const;
template std::vector<std::int32_t> Hdf5Object::read(const Slab&) const;
template std::vector<std::int64_t> Hdf5Object::read(const Slab&) const;

}  // namespace aeolic
