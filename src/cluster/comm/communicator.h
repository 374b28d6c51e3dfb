#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/timing.h"
#include "base/uninitialized.h"

namespace aeolic {

using ByteSpan = std::span<const std::byte>;

/// One rank hands this to another in an exchange. `rank` is the receiver on the way out, the sender on the way in.
struct Message {
    int rank = 0;
    Bytes bytes;
};

/// Bytes on their way out, where they lie.
struct OutgoingBytes {
    int rank = 0;  ///< Who receives them.
    ByteSpan bytes;
};

/// The place for bytes that come in.
struct IncomingBytes {
    int rank = 0;                ///< The sender.
    std::span<std::byte> bytes;  ///< As many as are sent.
};

/// What a rank handed to others, or got from them. Its own share of every collective is counted as plain direct
/// messages: a broadcast is size-1 messages of the root, an all-gather size-1 messages of every rank (in place: those
/// that are really sent). So the numbers say what the program asked for, not what a library made of it, and are the
/// same for every kind of communicator. What a rank sends itself does not count.
struct Traffic {
    std::int64_t bytes = 0, messages = 0;
    void add(std::int64_t messageBytes) { bytes += messageBytes, messages += 1; }
    bool operator==(const Traffic&) const = default;
};

enum class Reduction { min, max, sum };

/// One rank's view of the group of processes that draw a frame together. Bytes travel as they lie in memory: all ranks
/// run on the same kind of machine.
///
/// A *Collective* method must be called by every rank, in the same order; one missing rank is a deadlock. A *Local* one
/// concerns nobody else. Errors are std::runtime_error naming the rank; the group is then unusable: call abortJob().
/// Not thread-safe: one thread of a rank at a time. Destruction is Collective too, except while an exception unwinds.
class Communicator {
public:
    /// `ranksAre`: whose CPU time a rank's is. A thread that is a rank may share its core with others, so that its wall
    /// time says little: for it, CPU time is working time as well.
    explicit Communicator(BusyClock::Of ranksAre = BusyClock::Of::process)
        : busy_(ranksAre), working_(ranksAre == BusyClock::Of::thread ? ranksAre : BusyClock::Of::wall)
    {
    }
    virtual ~Communicator() = default;
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;

    virtual std::string name() const = 0;  ///< Local. serial | mpi | threads
    virtual int rank() const = 0;          ///< Local. [0, size)
    virtual int size() const = 0;          ///< Local. At least 1.
    bool isRoot() const { return rank() == 0; }

    /// Collective. Returns when all ranks have come this far.
    void barrier();

    /// Collective. On return `bytes` is on every rank what it was on `root`; its size travels too.
    void broadcast(Bytes& bytes, int root = 0);

    /// Collective. On `root`: what every rank gave, by rank. Elsewhere: empty.
    std::vector<Bytes> gather(ByteSpan mine, int root = 0);

    /// Collective. gather() into memory that is kept: on `root` all[r] becomes what rank r gave, elsewhere `all` stays
    /// what it is. One message a rank, which brings its size with it.
    void gatherInto(std::vector<Bytes>& all, ByteSpan mine, int root = 0);

    /// Collective. What every rank gave, by rank, on every rank.
    std::vector<Bytes> allGather(ByteSpan mine);

    /// Collective. allGather() where everyone knows how much each gives: `all` is what the ranks give, one after the
    /// other, bytes[r] of rank r, of which each rank fills in its own. Cost: ⌈log2 size⌉ messages instead of size-1,
    /// one after the other, each of all that its sender has by then (Bruck, Ho, Kipnis, Upfal & Weathersby, IEEE TPDS
    /// 8(11), 1997, its concatenation), and a copy.
    void allGatherInPlace(std::span<std::byte> all, const std::vector<std::size_t>& bytes);

    /// Collective. Every rank's value, by rank, on every rank.
    std::vector<std::int64_t> allGatherValue(std::int64_t value);

    /// Collective. Hands values[r] to rank r, one value for every rank; what each rank handed to this one, by rank.
    std::vector<std::int64_t> allToAll(const std::vector<std::int64_t>& values);

    /// Collective. values[i] becomes the minimum, maximum or sum over all ranks' values[i]; the same number of values
    /// everywhere. Folded in rank order, so every rank gets the same bytes. A sum of doubles still depends on how its
    /// terms were split among ranks: good for statistics, never for what reaches a pixel.
    void allReduce(std::span<double> values, Reduction how);
    void allReduce(std::span<std::int64_t> values, Reduction how);

    /// Collective. One value.
    template <class Number>
    requires std::is_arithmetic_v<Number> Number allReduce(Number value, Reduction how)
    {
        allReduce(std::span(&value, 1), how);
        return value;
    }

    /// Collective. Sends every outgoing message and returns those that came, by ascending sender. At most one message
    /// per receiver, oneself included; empty ones are not delivered. Cost beside the messages: 8 bytes to every rank,
    /// so that every rank learns the sizes of its messages.
    std::vector<Message> exchange(std::vector<Message> outgoing);

    /// Collective among those who exchange something; nobody else need call it. An exchange() where every rank knows
    /// these sizes: bytes go from where they lie to where they belong, without a copy of ours. Any number for a rank,
    /// never oneself; they arrive in the order in which they are given. Empty ones are not sent. Throws where
    /// `incoming` is not what the others send.
    void exchangeInPlace(std::vector<OutgoingBytes> outgoing, std::vector<IncomingBytes> incoming);

    /// Local. Whether this rank is the first of its host, which reads for all ranks there.
    virtual bool isFirstOnHost() const { return isRoot(); }

    /// Collective. What the first rank of this host gives, in memory that the host has once; the others give nothing.
    /// It is not to be written to, and must not outlive this. Where a host has no room for memory that processes share
    /// every rank gets a copy of its own. Cost: a copy, unless the ranks are threads of one process.
    std::shared_ptr<const void> shareOnHost(std::shared_ptr<const void> mine, std::size_t bytes);

    /// Local. What this rank has sent since construction, and what it has received.
    const Traffic& sent() const { return sent_; }
    const Traffic& received() const { return received_; }

    /// Local. The rank's clocks. They run from where a rank starts them, and stand during every Collective method.
    /// `busy` is the CPU time of all threads. `working` is the time that passes meanwhile: a rank with more threads has
    /// done as much after less of it.
    BusyClock& busy() { return busy_; }
    BusyClock& working() { return working_; }

    /// Local. Ends every rank's process, with one line on standard error, `message` and the rank that says it, and with
    /// `exitCode`, not 0. Cleans up nothing. (In-process ranks are ended by an exception instead.)
    [[noreturn]] virtual void abortJob(const std::string& message, int exitCode = 1) = 0;

private:
    /// Both clocks stand while this exists.
    struct Waiting {
        explicit Waiting(Communicator& rank) : busy(rank.busy_), working(rank.working_) {}
        BusyClock::Pause busy, working;
    };

    // Each kind of communicator implements these. Arguments are checked, and messages to oneself are dealt with.
    virtual void doBarrier() = 0;
    virtual void doBroadcast(Bytes& bytes, int root) = 0;
    virtual void doGather(std::vector<Bytes>& all, ByteSpan mine, int root) = 0;  ///< On `root` [size] already.
    virtual std::vector<Bytes> doAllGather(ByteSpan mine) = 0;
    virtual std::vector<std::int64_t> doAllToAll(const std::vector<std::int64_t>& toRank) = 0;
    /// Never oneself, never empty, at least one of either.
    virtual void doExchange(const std::vector<OutgoingBytes>& outgoing, const std::vector<IncomingBytes>& incoming) = 0;
    virtual std::shared_ptr<const void> doShareOnHost(std::shared_ptr<const void> mine, std::size_t)
    {
        return mine;  // A rank alone.
    }

    template <class T>
    void fold(std::span<T> values, Reduction how);
    void countToOthers(std::size_t bytes);
    void countFromOthers(const std::vector<Bytes>& all);
    void requireRank(int rank, const char* operation) const;
    void requireOther(int rank, const char* operation) const;
    void checkExchange(const std::vector<Message>& outgoing) const;

    Traffic sent_, received_;
    BusyClock busy_, working_;
};

/// Local. Rank 0 of 1: what a single process uses, so that the frame needs no special case.
std::unique_ptr<Communicator> makeSerialCommunicator();

/// Collective. The communicator this process was started for: MPI under an MPI launcher (mpirun, srun …), else serial,
/// which costs no MPI start-up. Throws InputError where the launcher and this build do not fit each other.
std::unique_ptr<Communicator> makeCommunicator();

}  // namespace aeolic
