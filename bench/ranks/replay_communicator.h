#pragma once

#include <cstdlib>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// What a rank received from others, in order.
class Recording {
public:
    /// Forgets all messages. Their memory stays for the next ones.
    void clear() { count_ = next_ = 0; }
    /// Starts giving from the beginning again.
    void rewind() { next_ = 0; }

    void keep(const char* operation, ByteSpan bytes);
    /// The next message kept. Throws std::logic_error where another operation kept it, or nothing is left.
    const Bytes& next(const char* operation);

private:
    struct Received {
        const char* operation;
        Bytes bytes;
    };
    std::vector<Received> received_;
    std::size_t count_ = 0, next_ = 0;
};

/// A rank's place in a group, in which it can do again by itself what it did with the others: it receives at once what
/// it received then, and what it sends goes nowhere. This measures what a rank takes where nobody else computes.
///
/// The rank must do the same again: std::logic_error where operations come in another order, or with other sizes.
class ReplayCommunicator final : public Communicator {
public:
    explicit ReplayCommunicator(Communicator& others) : Communicator(others.busy().of()), others_(others) {}

    /// Local. From here on the rank is with the others, and `into` gets what it receives, and nothing else.
    void record(Recording& into);
    /// Local. From here on the rank is alone and receives what `from` has, from its beginning.
    void replay(Recording& from);

    std::string name() const override { return others_.name(); }
    int rank() const override { return others_.rank(); }
    int size() const override { return others_.size(); }
    bool isFirstOnHost() const override { return others_.isFirstOnHost(); }

    [[noreturn]] void abortJob(const std::string& message, int exitCode) override
    {
        others_.abortJob(message, exitCode);
        std::abort();  // Not reached, which the compiler does not see.
    }

private:
    void doBarrier() override;
    void doBroadcast(Bytes& bytes, int root) override;
    void doGather(std::vector<Bytes>& all, ByteSpan mine, int root) override;
    std::vector<Bytes> doAllGather(ByteSpan mine) override;
    std::vector<std::int64_t> doAllToAll(const std::vector<std::int64_t>& toRank) override;
    void doExchange(const std::vector<OutgoingBytes>& outgoing, const std::vector<IncomingBytes>& incoming) override;

    std::shared_ptr<const void> doShareOnHost(std::shared_ptr<const void> mine, std::size_t bytes) override;

    std::vector<Bytes> keepAll(const char* operation, std::vector<Bytes> all);
    std::vector<Bytes> allAgain(const char* operation);

    Communicator& others_;
    std::vector<std::shared_ptr<const void>> shared_;  // What was shared; a recording has the number alone.
    Recording* recording_ = nullptr;
    bool alone_ = false;
};

}  // namespace aeolic
