#include "cluster/communicator.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace aeolic {
namespace {

template <class T>
T combine(T a, T b, Reduction how)
{
    switch (how) {
        case Reduction::min:
            return std::min(a, b);
        case Reduction::max:
            return std::max(a, b);
        case Reduction::sum:
            break;
    }
    return a + b;
}

}  // namespace

void Communicator::barrier()
{
    countToOthers(0);
    doBarrier();
    received_.messages += size() - 1;
}

void Communicator::broadcast(Bytes& bytes, int root)
{
    requireRank(root, "broadcast");
    if (rank() == root) countToOthers(bytes.size());
    doBroadcast(bytes, root);
    if (rank() != root) received_.add(std::int64_t(bytes.size()));
}

std::vector<Bytes> Communicator::gather(ByteSpan mine, int root)
{
    requireRank(root, "gather");
    if (rank() != root) sent_.add(std::int64_t(mine.size()));
    std::vector<Bytes> all = doGather(mine, root);
    if (rank() == root) countFromOthers(all);
    return all;
}

void Communicator::gatherInPlace(ByteSpan mine, std::span<std::byte> all, const std::vector<std::int64_t>& sizes)
{
    if (int(sizes.size()) != size()) throw std::logic_error("gatherInPlace: one size for every rank");
    if (!isRoot()) {
        if (std::int64_t(mine.size()) != sizes[std::size_t(rank())])
            throw std::runtime_error("rank " + std::to_string(rank()) +
                                     ": gatherInPlace: " + std::to_string(mine.size()) + " bytes where " +
                                     std::to_string(sizes[std::size_t(rank())]) + " were announced");
        if (mine.empty()) return;
        sent_.add(std::int64_t(mine.size()));
        doSendToRoot(mine);
        return;
    }
    std::vector<std::span<std::byte>> parts;
    std::size_t at = 0;
    for (const std::int64_t bytes : sizes) {
        if (at + std::size_t(bytes) > all.size()) throw std::logic_error("gatherInPlace: no room for all ranks");
        parts.push_back(all.subspan(at, std::size_t(bytes)));
        at += std::size_t(bytes);
    }
    parts[0] = {};
    for (const auto& part : parts)
        if (!part.empty()) received_.add(std::int64_t(part.size()));
    doReceiveOnRoot(parts);
}

std::vector<Bytes> Communicator::allGather(ByteSpan mine)
{
    countToOthers(mine.size());
    std::vector<Bytes> all = doAllGather(mine);
    countFromOthers(all);
    return all;
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

void Communicator::allReduce(std::span<double> values, Reduction how)
{
    fold(values, how);
}

void Communicator::allReduce(std::span<std::int64_t> values, Reduction how)
{
    fold(values, how);
}

double Communicator::allReduce(double value, Reduction how)
{
    fold(std::span(&value, 1), how);
    return value;
}

std::int64_t Communicator::allReduce(std::int64_t value, Reduction how)
{
    fold(std::span(&value, 1), how);
    return value;
}

std::vector<Message> Communicator::exchange(std::vector<Message> outgoing)
{
    checkExchange(outgoing);
    std::vector<std::int64_t> toRank(std::size_t(size()), 0);
    for (const Message& message : outgoing) toRank[std::size_t(message.rank)] = std::int64_t(message.bytes.size());
    countToOthers(sizeof(std::int64_t));
    const std::vector<std::int64_t> fromRank = doAllToAll(toRank);
    received_.messages += size() - 1;
    received_.bytes += std::int64_t(size() - 1) * std::int64_t(sizeof(std::int64_t));
    std::vector<Announced> incoming;
    incoming.reserve(fromRank.size());
    for (int r = 0; r < size(); ++r) incoming.push_back({r, fromRank[std::size_t(r)]});
    return exchange(std::move(outgoing), incoming);
}

std::vector<Message> Communicator::exchange(std::vector<Message> outgoing, const std::vector<Announced>& incoming)
{
    checkExchange(outgoing);
    Message own = takeOwn(outgoing);
    std::erase_if(outgoing, [](const Message& message) { return message.bytes.empty(); });
    for (const Message& message : outgoing) sent_.add(std::int64_t(message.bytes.size()));

    std::int64_t ownAnnounced = 0;
    std::vector<Announced> fromOthers;
    for (const Announced& announced : incoming) {
        requireRank(announced.rank, "exchange");
        if (announced.rank == rank())
            ownAnnounced = announced.bytes;
        else if (announced.bytes > 0)
            fromOthers.push_back(announced);
    }
    if (ownAnnounced != std::int64_t(own.bytes.size()))
        throw std::runtime_error("rank " + std::to_string(rank()) + ": exchange: expected " +
                                 std::to_string(ownAnnounced) + " bytes from itself, sent " +
                                 std::to_string(own.bytes.size()));

    std::vector<Message> received;
    if (!outgoing.empty() || !fromOthers.empty()) received = doExchange(std::move(outgoing), fromOthers);
    for (const Message& message : received) received_.add(std::int64_t(message.bytes.size()));
    if (!own.bytes.empty()) received.push_back(std::move(own));
    std::sort(received.begin(), received.end(), [](const Message& a, const Message& b) { return a.rank < b.rank; });
    return received;
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

Message Communicator::takeOwn(std::vector<Message>& outgoing) const
{
    Message own{rank(), {}};
    const auto found =
        std::find_if(outgoing.begin(), outgoing.end(), [&](const Message& message) { return message.rank == rank(); });
    if (found != outgoing.end()) {
        own.bytes = std::move(found->bytes);
        outgoing.erase(found);
    }
    return own;
}

}  // namespace aeolic
