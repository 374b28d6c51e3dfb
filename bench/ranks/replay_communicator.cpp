#include "ranks/replay_communicator.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace aeolic {

void Recording::keep(const char* operation, ByteSpan bytes)
{
    if (count_ == received_.size()) received_.emplace_back();
    Received& received = received_[count_++];
    received.operation = operation;
    received.bytes.assign(bytes.begin(), bytes.end());
}

const Bytes& Recording::next(const char* operation)
{
    if (next_ == count_) throw std::logic_error(std::string("replay: ") + operation + " after all that was recorded");
    const Received& received = received_[next_++];
    if (std::strcmp(received.operation, operation) != 0)
        throw std::logic_error(std::string("replay: ") + operation + " where " + received.operation + " was recorded");
    return received.bytes;
}

void ReplayCommunicator::record(Recording& into)
{
    into.clear();
    recording_ = &into;
    alone_ = false;
}

void ReplayCommunicator::replay(Recording& from)
{
    from.rewind();
    recording_ = &from;
    alone_ = true;
}

std::vector<Bytes> ReplayCommunicator::keepAll(const char* operation, std::vector<Bytes> all)
{
    for (const Bytes& given : all)
        if (recording_) recording_->keep(operation, given);
    return all;
}

std::vector<Bytes> ReplayCommunicator::allAgain(const char* operation)
{
    std::vector<Bytes> all;
    all.reserve(std::size_t(size()));
    for (int r = 0; r < size(); ++r) all.push_back(recording_->next(operation));
    return all;
}

void ReplayCommunicator::doBarrier()
{
    if (!alone_) others_.barrier();
}

void ReplayCommunicator::doBroadcast(Bytes& bytes, int root)
{
    if (alone_) {
        bytes = recording_->next("broadcast");
        return;
    }
    others_.broadcast(bytes, root);
    if (recording_) recording_->keep("broadcast", bytes);
}

void ReplayCommunicator::doGather(std::vector<Bytes>& all, ByteSpan mine, int root)
{
    if (!alone_) others_.gatherInto(all, mine, root);
    if (rank() != root) return;
    for (Bytes& given : all) {
        if (alone_)
            given = recording_->next("gather");
        else if (recording_)
            recording_->keep("gather", given);
    }
}

std::vector<Bytes> ReplayCommunicator::doAllGather(ByteSpan mine)
{
    return alone_ ? allAgain("allGather") : keepAll("allGather", others_.allGather(mine));
}

std::vector<std::int64_t> ReplayCommunicator::doAllToAll(const std::vector<std::int64_t>& toRank)
{
    if (!alone_) {
        std::vector<std::int64_t> values = others_.allToAll(toRank);
        if (recording_) recording_->keep("allToAll", std::as_bytes(std::span(values)));
        return values;
    }
    std::vector<std::int64_t> values(toRank.size());
    std::memcpy(values.data(), recording_->next("allToAll").data(), std::span(values).size_bytes());
    return values;
}

void ReplayCommunicator::doExchange(const std::vector<OutgoingBytes>& outgoing,
                                    const std::vector<IncomingBytes>& incoming)
{
    if (!alone_) others_.exchangeInPlace(outgoing, incoming);
    for (const IncomingBytes& part : incoming) {
        if (!alone_) {
            if (recording_) recording_->keep("exchange", part.bytes);
            continue;
        }
        const Bytes& bytes = recording_->next("exchange");
        if (bytes.size() != part.bytes.size())
            throw std::logic_error("replay: " + std::to_string(part.bytes.size()) + " bytes from rank " +
                                   std::to_string(part.rank) + " where " + std::to_string(bytes.size()) +
                                   " were recorded");
        std::copy(bytes.begin(), bytes.end(), part.bytes.begin());
    }
}

std::shared_ptr<const void> ReplayCommunicator::doShareOnHost(std::shared_ptr<const void> mine, std::size_t bytes)
{
    std::size_t number = shared_.size();
    if (alone_) {
        std::memcpy(&number, recording_->next("shareOnHost").data(), sizeof number);
        return shared_.at(number);
    }
    shared_.push_back(others_.shareOnHost(std::move(mine), bytes));
    if (recording_) recording_->keep("shareOnHost", std::as_bytes(std::span(&number, 1)));
    return shared_.back();
}

}  // namespace aeolic
