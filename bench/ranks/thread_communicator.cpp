#include "ranks/thread_communicator.h"

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace aeolic {
namespace {

/// Thrown in ranks that wait when another one fails; never seen outside runRanks().
struct Released : std::runtime_error {
    Released() : std::runtime_error("another rank failed") {}
};

/// A mailbox for every pair of ranks. All collectives are sends, which never block, and receives from a named rank.
class Group {
public:
    explicit Group(int ranks)
        : size_(ranks),
          mailboxes_(std::size_t(ranks) * std::size_t(ranks)),
          waitsFor_(std::size_t(ranks), kNobody),
          left_(std::size_t(ranks), false)
    {
    }

    int size() const { return size_; }

    void send(int from, int to, const char* operation, Bytes bytes)
    {
        const std::lock_guard lock(mutex_);
        if (failure_) throw Released();
        mailbox(from, to).push_back({operation, std::move(bytes)});
        changed_.notify_all();
    }

    Bytes receive(int from, int to, const char* operation)
    {
        std::unique_lock lock(mutex_);
        waitForMail(lock, from, to, operation);
        Letter letter = std::move(mailbox(from, to).front());
        mailbox(from, to).pop_front();
        if (std::strcmp(letter.operation, operation) != 0)
            throw std::logic_error(rankText(to) + " is in " + operation + " while " + rankText(from) + " is in " +
                                   letter.operation);
        return std::move(letter.bytes);
    }

    void leave(int rank)
    {
        const std::lock_guard lock(mutex_);
        left_[std::size_t(rank)] = true;
        changed_.notify_all();
    }

    void fail(std::exception_ptr error)
    {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::move(error);
        changed_.notify_all();
    }

    /// After all threads have ended.
    void rethrow() const
    {
        if (failure_) std::rethrow_exception(failure_);
        for (int from = 0; from < size_; ++from)
            for (int to = 0; to < size_; ++to)
                if (const auto& mail = mailboxes_[index(from, to)]; !mail.empty())
                    throw std::logic_error(rankText(to) + " left without the message of " + rankText(from) + " from " +
                                           mail.front().operation);
    }

private:
    struct Letter {
        const char* operation;
        Bytes bytes;
    };
    static constexpr int kNobody = -1;

    static std::string rankText(int rank) { return "rank " + std::to_string(rank); }
    std::size_t index(int from, int to) const { return std::size_t(from) * std::size_t(size_) + std::size_t(to); }
    std::deque<Letter>& mailbox(int from, int to) { return mailboxes_[index(from, to)]; }

    void waitForMail(std::unique_lock<std::mutex>& lock, int from, int to, const char* operation)
    {
        int& waitsFor = waitsFor_[std::size_t(to)];
        waitsFor = from;
        std::string hang;
        while (!failure_ && mailbox(from, to).empty()) {
            if (left_[std::size_t(from)])
                hang = rankText(from) + ", which has left";
            else if (everyoneWaits())
                hang = rankText(from) + ", and all other ranks wait too";
            if (!hang.empty()) break;
            changed_.wait(lock);
        }
        waitsFor = kNobody;
        if (failure_) throw Released();
        if (!hang.empty()) throw std::logic_error(rankText(to) + " waits in " + operation + " for " + hang);
    }

    bool everyoneWaits()
    {
        for (int rank = 0; rank < size_; ++rank) {
            const int from = waitsFor_[std::size_t(rank)];
            if (left_[std::size_t(rank)]) continue;
            if (from == kNobody || !mailbox(from, rank).empty() || left_[std::size_t(from)]) return false;
        }
        return true;
    }

    const int size_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::deque<Letter>> mailboxes_;  // [from][to]
    std::vector<int> waitsFor_;                  // [rank]
    std::vector<bool> left_;                     // [rank]
    std::exception_ptr failure_;
};

class ThreadCommunicator final : public Communicator {
public:
    ThreadCommunicator(Group& group, int rank) : Communicator(BusyClock::Of::thread), group_(group), rank_(rank) {}

    std::string name() const override { return "threads"; }
    int rank() const override { return rank_; }
    int size() const override { return group_.size(); }

    [[noreturn]] void abortJob(const std::string& message, int) override
    {
        throw std::runtime_error("rank " + std::to_string(rank_) + ": " + message);
    }

private:
    void sendToOthers(const char* operation, ByteSpan bytes)
    {
        for (int r = 0; r < size(); ++r)
            if (r != rank_) group_.send(rank_, r, operation, Bytes(bytes.begin(), bytes.end()));
    }

    void doBarrier() override
    {
        sendToOthers("barrier", {});
        for (int r = 0; r < size(); ++r)
            if (r != rank_) group_.receive(r, rank_, "barrier");
    }

    void doBroadcast(Bytes& bytes, int root) override
    {
        if (rank_ == root)
            sendToOthers("broadcast", bytes);
        else
            bytes = group_.receive(root, rank_, "broadcast");
    }

    void doGather(std::vector<Bytes>& all, ByteSpan mine, int root) override
    {
        if (rank_ != root)
            group_.send(rank_, root, "gather", Bytes(mine.begin(), mine.end()));
        else
            all = receiveFromAll("gather", mine);
    }

    std::vector<Bytes> doAllGather(ByteSpan mine) override
    {
        sendToOthers("allGather", mine);
        return receiveFromAll("allGather", mine);
    }

    std::vector<Bytes> receiveFromAll(const char* operation, ByteSpan mine)
    {
        std::vector<Bytes> all;
        all.reserve(std::size_t(size()));
        for (int r = 0; r < size(); ++r)
            all.push_back(r == rank_ ? Bytes(mine.begin(), mine.end()) : group_.receive(r, rank_, operation));
        return all;
    }

    std::vector<std::int64_t> doAllToAll(const std::vector<std::int64_t>& toRank) override
    {
        for (int r = 0; r < size(); ++r)
            if (r != rank_) {
                const ByteSpan bytes = std::as_bytes(std::span(&toRank[std::size_t(r)], 1));
                group_.send(rank_, r, "exchange's sizes", Bytes(bytes.begin(), bytes.end()));
            }
        std::vector<std::int64_t> fromRank(toRank);
        for (int r = 0; r < size(); ++r)
            if (r != rank_)
                std::memcpy(&fromRank[std::size_t(r)], group_.receive(r, rank_, "exchange's sizes").data(),
                            sizeof(std::int64_t));
        return fromRank;
    }

    void doExchange(const std::vector<OutgoingBytes>& outgoing, const std::vector<IncomingBytes>& incoming) override
    {
        for (const OutgoingBytes& part : outgoing)
            group_.send(rank_, part.rank, "exchange", Bytes(part.bytes.begin(), part.bytes.end()));
        for (const IncomingBytes& part : incoming) {
            const Bytes bytes = group_.receive(part.rank, rank_, "exchange");
            if (bytes.size() != part.bytes.size())
                throw std::logic_error("rank " + std::to_string(rank_) + ": expected " +
                                       std::to_string(part.bytes.size()) + " bytes from rank " +
                                       std::to_string(part.rank) + ", received " + std::to_string(bytes.size()));
            std::copy(bytes.begin(), bytes.end(), part.bytes.begin());
        }
    }

    /// All ranks see all of the process's memory.
    std::shared_ptr<const void> doShareOnHost(std::shared_ptr<const void> mine, std::size_t) override
    {
        const std::shared_ptr<const void>* address = &mine;
        Bytes bytes(sizeof address);
        std::memcpy(bytes.data(), &address, sizeof address);
        doBroadcast(bytes, 0);
        std::memcpy(&address, bytes.data(), sizeof address);
        std::shared_ptr<const void> shared = *address;
        doBarrier();  // Until then it must stay where it is.
        return shared;
    }

    Group& group_;
    const int rank_;
};

}  // namespace

void runRanks(int ranks, const std::function<void(Communicator&)>& body)
{
    Group group(ranks);
    const auto runRank = [&](int rank) {
        try {
            ThreadCommunicator communicator(group, rank);
            body(communicator);
        } catch (...) {
            group.fail(std::current_exception());
        }
        group.leave(rank);
    };
    std::vector<std::thread> threads;
    threads.reserve(std::size_t(ranks));
    for (int rank = 0; rank < ranks; ++rank) threads.emplace_back(runRank, rank);
    for (std::thread& thread : threads) thread.join();
    group.rethrow();
}

}  // namespace aeolic
