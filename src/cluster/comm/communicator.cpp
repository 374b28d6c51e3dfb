#include "cluster/comm/communicator.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace aeolic {
namespace {

template <class T>
T combine(T a, T b, Reduction how)
{
    return how == Reduction::min ? std::min(a, b) : how == Reduction::max ? std::max(a, b) : a + b;
}

}  // namespace

void Communicator::barrier()
{
    const Waiting waiting(*this);
    countToOthers(0);
    doBarrier();
    received_.messages += size() - 1;
}

void Communicator::broadcast(Bytes& bytes, int root)
{
    const Waiting waiting(*this);
    requireRank(root, "broadcast");
    if (rank() == root) countToOthers(bytes.size());
    doBroadcast(bytes, root);
    if (rank() != root) received_.add(std::int64_t(bytes.size()));
}

std::shared_ptr<const void> Communicator::shareOnHost(std::shared_ptr<const void> mine, std::size_t bytes)
{
    const Waiting waiting(*this);
    return doShareOnHost(std::move(mine), bytes);
}

std::vector<Bytes> Communicator::gather(ByteSpan mine, int root)
{
    std::vector<Bytes> all;
    gatherInto(all, mine, root);
    return all;
}

void Communicator::gatherInto(std::vector<Bytes>& all, ByteSpan mine, int root)
{
    const Waiting waiting(*this);
    requireRank(root, "gather");
    if (rank() == root)
        all.resize(std::size_t(size()));
    else
        sent_.add(std::int64_t(mine.size()));
    doGather(all, mine, root);
    if (rank() == root) countFromOthers(all);
}

std::vector<Bytes> Communicator::allGather(ByteSpan mine)
{
    const Waiting waiting(*this);
    countToOthers(mine.size());
    std::vector<Bytes> all = doAllGather(mine);
    countFromOthers(all);
    return all;
}

void Communicator::allGatherInPlace(std::span<std::byte> all, const std::vector<std::size_t>& bytes)
{
    const Waiting waiting(*this);
    const std::size_t n = std::size_t(size()), me = std::size_t(rank());
    if (bytes.size() != n || std::accumulate(bytes.begin(), bytes.end(), std::size_t{0}) != all.size())
        throw std::logic_error("allGatherInPlace: room for what every rank gives");
    if (n == 1) return;
    // Turned so that this rank's part comes first, and the first rank's after the last one's. So the parts that are
    // there already are always in one piece.
    std::vector<std::size_t> end(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i) end[i + 1] = end[i] + bytes[(me + i) % n];
    const std::size_t before = std::accumulate(bytes.begin(), bytes.begin() + std::ptrdiff_t(me), std::size_t{0});
    Bytes turned(all.size());
    std::copy_n(all.begin() + std::ptrdiff_t(before), bytes[me], turned.begin());
    for (std::size_t had = 1; had < n; had *= 2) {
        const std::size_t more = std::min(had, n - had);
        exchangeInPlace({{int((me + n - had) % n), std::span(turned).first(end[more])}},
                        {{int((me + had) % n), std::span(turned).subspan(end[had], end[had + more] - end[had])}});
    }
    std::rotate_copy(turned.begin(), turned.end() - std::ptrdiff_t(before), turned.end(), all.begin());
}

template <class T>
void Communicator::fold(std::span<T> values, Reduction how)
{
    const std::vector<Bytes> all = allGather(std::as_bytes(values));
    for (const Bytes& given : all)
        if (given.size() != values.size_bytes())
            throw std::runtime_error("rank " + std::to_string(rank()) + ": allReduce of " +
                                     std::to_string(values.size()) + " values, another rank gave " +
                                     std::to_string(given.size() / sizeof(T)));
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t r = 0; r < all.size(); ++r) {
            T value;
            std::memcpy(&value, all[r].data() + i * sizeof(T), sizeof(T));
            values[i] = r == 0 ? value : combine(values[i], value, how);
        }
}

std::vector<std::int64_t> Communicator::allGatherValue(std::int64_t value)
{
    std::vector<std::int64_t> values;
    for (const Bytes& bytes : allGather(std::as_bytes(std::span(&value, 1)))) {
        values.push_back(0);
        if (bytes.size() != sizeof value)
            throw std::runtime_error("rank " + std::to_string(rank()) + ": allGatherValue, another rank gave " +
                                     std::to_string(bytes.size()) + " bytes");
        std::memcpy(&values.back(), bytes.data(), sizeof value);
    }
    return values;
}

std::vector<std::int64_t> Communicator::allToAll(const std::vector<std::int64_t>& values)
{
    const Waiting waiting(*this);
    if (int(values.size()) != size()) throw std::logic_error("allToAll: one value for every rank");
    countToOthers(sizeof(std::int64_t));
    std::vector<std::int64_t> received = doAllToAll(values);
    received_.messages += size() - 1;
    received_.bytes += std::int64_t(size() - 1) * std::int64_t(sizeof(std::int64_t));
    return received;
}

void Communicator::allReduce(std::span<double> values, Reduction how)
{
    fold(values, how);
}

void Communicator::allReduce(std::span<std::int64_t> values, Reduction how)
{
    fold(values, how);
}

std::vector<Message> Communicator::exchange(std::vector<Message> outgoing)
{
    const Waiting waiting(*this);
    checkExchange(outgoing);
    std::vector<std::int64_t> toRank(std::size_t(size()), 0);
    for (const Message& message : outgoing) toRank[std::size_t(message.rank)] = std::int64_t(message.bytes.size());
    const std::vector<std::int64_t> fromRank = allToAll(toRank);

    std::vector<Message> received;
    std::vector<OutgoingBytes> out;
    std::vector<IncomingBytes> in;
    for (int r = 0; r < size(); ++r)
        if (r != rank() && fromRank[std::size_t(r)] > 0)
            received.push_back({r, Bytes(std::size_t(fromRank[std::size_t(r)]))});
    in.reserve(received.size());
    for (Message& message : received) in.push_back({message.rank, message.bytes});
    for (const Message& message : outgoing)
        if (message.rank != rank()) out.push_back({message.rank, message.bytes});
    exchangeInPlace(std::move(out), std::move(in));
    for (Message& message : outgoing)
        if (message.rank == rank() && !message.bytes.empty()) received.push_back(std::move(message));
    std::sort(received.begin(), received.end(), [](const Message& a, const Message& b) { return a.rank < b.rank; });
    return received;
}

void Communicator::exchangeInPlace(std::vector<OutgoingBytes> outgoing, std::vector<IncomingBytes> incoming)
{
    const Waiting waiting(*this);
    const auto isEmpty = [](const auto& part) { return part.bytes.empty(); };
    std::erase_if(outgoing, isEmpty);
    std::erase_if(incoming, isEmpty);
    for (const OutgoingBytes& part : outgoing) {
        requireOther(part.rank, "exchange");
        sent_.add(std::int64_t(part.bytes.size()));
    }
    for (const IncomingBytes& part : incoming) {
        requireOther(part.rank, "exchange");
        received_.add(std::int64_t(part.bytes.size()));
    }
    if (!outgoing.empty() || !incoming.empty()) doExchange(outgoing, incoming);
}

void Communicator::countToOthers(std::size_t bytes)
{
    sent_.messages += size() - 1;
    sent_.bytes += std::int64_t(size() - 1) * std::int64_t(bytes);
}

void Communicator::countFromOthers(const std::vector<Bytes>& all)
{
    for (int r = 0; r < size(); ++r)
        if (r != rank()) received_.add(std::int64_t(all[std::size_t(r)].size()));
}

void Communicator::requireRank(int other, const char* operation) const
{
    if (other < 0 || other >= size())
        throw std::logic_error("rank " + std::to_string(rank()) + ": " + operation + " with rank " +
                               std::to_string(other) + " in a group of " + std::to_string(size()));
}

void Communicator::requireOther(int other, const char* operation) const
{
    requireRank(other, operation);
    if (other == rank()) throw std::logic_error("rank " + std::to_string(rank()) + ": " + operation + " with itself");
}

void Communicator::checkExchange(const std::vector<Message>& outgoing) const
{
    std::vector<bool> addressed(std::size_t(size()), false);
    for (const Message& message : outgoing) {
        requireRank(message.rank, "exchange");
        if (addressed[std::size_t(message.rank)])
            throw std::logic_error("rank " + std::to_string(rank()) + ": exchange: two messages for rank " +
                                   std::to_string(message.rank));
        addressed[std::size_t(message.rank)] = true;
    }
}

}  // namespace aeolic
