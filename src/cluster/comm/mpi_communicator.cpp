// The one file of the program and the library that includes <mpi.h>. Plain MPI-3, in C: OpenMPI, MPICH and their
// relatives alike.
#include "cluster/comm/mpi_communicator.h"

#define OMPI_SKIP_MPICXX 1  // Not the C++ interface that MPI 3 removed: it would need a library of its own.
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <stdexcept>

#include "aeolic/error.h"
#include "base/parallel.h"

namespace aeolic {
namespace {

class MpiCommunicator final : public Communicator {
public:
    MpiCommunicator(std::int64_t chunkBytes, const void* callers);
    ~MpiCommunicator() override;

    std::string name() const override { return "mpi"; }
    int rank() const override { return rank_; }
    int size() const override { return size_; }
    bool isFirstOnHost() const override { return rankOnHost_ == 0; }
    [[noreturn]] void abortJob(const std::string& message, int exitCode) override;

private:
    void doBarrier() override { check(MPI_Barrier(comm_), "MPI_Barrier"); }
    void doBroadcast(Bytes& bytes, int root) override;
    void doGather(std::vector<Bytes>& all, ByteSpan mine, int root) override;
    std::vector<Bytes> doAllGather(ByteSpan mine) override;
    std::vector<std::int64_t> doAllToAll(const std::vector<std::int64_t>& toRank) override;
    void doExchange(const std::vector<OutgoingBytes>& outgoing, const std::vector<IncomingBytes>& incoming) override;

    std::shared_ptr<const void> doShareOnHost(std::shared_ptr<const void> mine, std::size_t bytes) override;

    void check(int code, const char* call) const;
    std::byte* allocateOnHost(std::size_t bytes, MPI_Win& window) const;
    void freeUnused(bool all);
    void waitAll(std::vector<MPI_Request>& requests, const std::vector<int>& expectedBytes) const;
    void sendWithSize(ByteSpan bytes, int to) const;
    void receiveWithSize(Bytes& bytes, int from, std::vector<MPI_Request>& requests) const;
    void broadcastInChunks(std::span<std::byte> bytes, int root) const;
    template <class Visit>
    void forEachChunk(std::size_t bytes, Visit visit) const;

    /// Memory that the ranks of a host share, and its users here. To free it is collective, so that has to wait until
    /// all come by.
    struct Shared {
        MPI_Win window;
        std::shared_ptr<char> users;
    };

    MPI_Comm comm_ = MPI_COMM_NULL, host_ = MPI_COMM_NULL;
    int rank_ = 0, size_ = 1, rankOnHost_ = 0;
    std::vector<Shared> shared_;  // In the order in which they came, on all ranks of the host.
    std::int64_t chunkBytes_;
    bool startedMpi_ = false;
    int exceptionsAtBirth_ = std::uncaught_exceptions();
};

// One tag is enough: messages between two ranks arrive in the order they were sent.
constexpr int kTag = 1;

bool hasEnded()
{
    int ended = 0;
    MPI_Finalized(&ended);
    return ended != 0;
}

/// Throws InputError for what MPI would end the process for.
void requireUsable(const MPI_Comm& callers)
{
    if (callers == MPI_COMM_NULL)
        throw InputError("joinRanks", "found MPI_COMM_NULL", "a communicator that this process belongs to");
    int between = 0;
    MPI_Comm_test_inter(callers, &between);
    if (between)
        throw InputError("joinRanks", "found an intercommunicator",
                         "ranks of one group, as MPI_Intercomm_merge makes of two");
}

MpiCommunicator::MpiCommunicator(std::int64_t chunkBytes, const void* callers) : chunkBytes_(chunkBytes)
{
    if (hasEnded()) throw InputError("joinRanks", "found MPI at its end", "a call before MPI_Finalize");
    int running = 0, provided = 0;
    MPI_Initialized(&running);
    if (callers && !running)
        throw InputError("MPI", "found a communicator, and MPI not started", "MPI_Init_thread before");
    if (callers) requireUsable(*static_cast<const MPI_Comm*>(callers));
    if (!running) {
        // Serialized: stages run in arenas, so the thread that calls MPI need not be the one that started it.
        check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided), "MPI_Init_thread");
        startedMpi_ = true;
        if (provided < MPI_THREAD_SERIALIZED)
            throw std::runtime_error("this MPI cannot serve programs with threads (MPI_THREAD_SERIALIZED)");
    }
    MPI_Query_thread(&provided);
    if (provided < MPI_THREAD_SERIALIZED)
        throw InputError("MPI", "started for fewer threads", "MPI_Init_thread with MPI_THREAD_SERIALIZED");
    check(MPI_Comm_dup(callers ? *static_cast<const MPI_Comm*>(callers) : MPI_COMM_WORLD, &comm_), "MPI_Comm_dup");
    MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN);
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
    check(MPI_Comm_split_type(comm_, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &host_), "MPI_Comm_split_type");
    MPI_Comm_set_errhandler(host_, MPI_ERRORS_RETURN);
    MPI_Comm_rank(host_, &rankOnHost_);
}

MpiCommunicator::~MpiCommunicator()
{
    // A rank that leaves by an exception must not wait here for the others, which may never come. It does not tell MPI,
    // and the launcher ends the job.
    if (std::uncaught_exceptions() > exceptionsAtBirth_) return;
    if (hasEnded()) return;  // MPI would end the process.
    try {
        freeUnused(true);
    } catch (const std::exception&) {  // What is left over at the end harms nobody.
    }
    MPI_Comm_free(&host_);
    MPI_Comm_free(&comm_);
    if (startedMpi_) MPI_Finalize();
}

/// MPI_Abort needs memory to tell the launcher, and threads of MPI to wait for its answer: where a rank has no memory
/// left it may not come back for many seconds. The launcher ends a job of which a process has ended, too.
void endAtTheLatestIn(unsigned seconds, int exitCode)
{
    static volatile std::sig_atomic_t code;
    code = exitCode;
    std::signal(SIGALRM, [](int) { _exit(code); });
    sigset_t alarms;
    sigemptyset(&alarms);
    sigaddset(&alarms, SIGALRM);
    pthread_sigmask(SIG_UNBLOCK, &alarms, nullptr);
    alarm(seconds);
}

void MpiCommunicator::abortJob(const std::string& message, int exitCode)
{
    const std::string who = "rank " + std::to_string(rank_) + ": ";  // The group's own errors begin with it.
    std::fprintf(stderr, "aeolic: %s%s\n", message.starts_with(who) ? "" : who.c_str(), message.c_str());
    std::fflush(nullptr);
    endAtTheLatestIn(2, exitCode);
    MPI_Abort(MPI_COMM_WORLD, exitCode);
    std::_Exit(exitCode);
}

void MpiCommunicator::check(int code, const char* call) const
{
    if (code == MPI_SUCCESS) return;
    char text[MPI_MAX_ERROR_STRING] = "";
    int length = 0;
    MPI_Error_string(code, text, &length);
    throw std::runtime_error("rank " + std::to_string(rank_) + ": " + call + " failed: " + text);
}

template <class Visit>
void MpiCommunicator::forEachChunk(std::size_t bytes, Visit visit) const
{
    const auto chunk = std::size_t(chunkBytes_);
    for (std::size_t at = 0; at < bytes; at += chunk) visit(at, int(std::min(chunk, bytes - at)));
}

void MpiCommunicator::waitAll(std::vector<MPI_Request>& requests, const std::vector<int>& expectedBytes) const
{
    std::vector<MPI_Status> statuses(requests.size());
    const int code = MPI_Waitall(int(requests.size()), requests.data(), statuses.data());
    if (code == MPI_ERR_IN_STATUS)
        for (const MPI_Status& status : statuses)
            if (status.MPI_ERROR != MPI_ERR_PENDING) check(status.MPI_ERROR, "a message");
    check(code, "MPI_Waitall");
    for (std::size_t i = 0; i < expectedBytes.size(); ++i) {
        int count = 0;
        MPI_Get_count(&statuses[i], MPI_BYTE, &count);
        if (count != expectedBytes[i])
            throw std::runtime_error("rank " + std::to_string(rank_) + ": expected " +
                                     std::to_string(expectedBytes[i]) + " bytes from rank " +
                                     std::to_string(statuses[i].MPI_SOURCE) + ", received " + std::to_string(count));
    }
}

void MpiCommunicator::doExchange(const std::vector<OutgoingBytes>& outgoing, const std::vector<IncomingBytes>& incoming)
{
    if (hasEnded()) throw std::runtime_error("rank " + std::to_string(rank_) + ": MPI has ended, expected it to run");
    std::vector<MPI_Request> requests;
    std::vector<int> expectedBytes;  // One for each receive; receives come first among the requests.
    for (const IncomingBytes& in : incoming)
        forEachChunk(in.bytes.size(), [&](std::size_t at, int count) {
            check(MPI_Irecv(in.bytes.data() + at, count, MPI_BYTE, in.rank, kTag, comm_, &requests.emplace_back()),
                  "MPI_Irecv");
            expectedBytes.push_back(count);
        });
    for (const OutgoingBytes& out : outgoing)
        forEachChunk(out.bytes.size(), [&](std::size_t at, int count) {
            check(MPI_Isend(out.bytes.data() + at, count, MPI_BYTE, out.rank, kTag, comm_, &requests.emplace_back()),
                  "MPI_Isend");
        });
    waitAll(requests, expectedBytes);
}

void MpiCommunicator::broadcastInChunks(std::span<std::byte> bytes, int root) const
{
    forEachChunk(bytes.size(), [&](std::size_t at, int count) {
        check(MPI_Bcast(bytes.data() + at, count, MPI_BYTE, root, comm_), "MPI_Bcast");
    });
}

void MpiCommunicator::doBroadcast(Bytes& bytes, int root)
{
    auto count = std::int64_t(bytes.size());
    check(MPI_Bcast(&count, 1, MPI_INT64_T, root, comm_), "MPI_Bcast");
    bytes.resize(std::size_t(count));
    broadcastInChunks(bytes, root);
}

// The receiver asks a message for its size before receiving it. A message of the largest size says that another one
// follows, perhaps an empty one.
void MpiCommunicator::sendWithSize(ByteSpan bytes, int to) const
{
    std::vector<MPI_Request> requests;
    const auto send = [&](std::size_t at, int count) {
        check(MPI_Isend(bytes.data() + at, count, MPI_BYTE, to, kTag, comm_, &requests.emplace_back()), "MPI_Isend");
    };
    forEachChunk(bytes.size(), send);
    if (bytes.size() % std::size_t(chunkBytes_) == 0) send(bytes.size(), 0);
    waitAll(requests, {});
}

void MpiCommunicator::receiveWithSize(Bytes& bytes, int from, std::vector<MPI_Request>& requests) const
{
    bytes.clear();
    for (int count = 0, isFirst = 1; isFirst || count == chunkBytes_; isFirst = 0) {
        MPI_Message message;
        MPI_Status status;
        check(MPI_Mprobe(from, kTag, comm_, &message, &status), "MPI_Mprobe");
        check(MPI_Get_count(&status, MPI_BYTE, &count), "MPI_Get_count");
        const std::size_t at = bytes.size();
        if (at > 0) {  // Bytes that are being received must not move.
            waitAll(requests, {});
            requests.clear();
        }
        bytes.resize(at + std::size_t(count));
        check(MPI_Imrecv(bytes.data() + at, count, MPI_BYTE, &message, &requests.emplace_back()), "MPI_Imrecv");
    }
}

void MpiCommunicator::doGather(std::vector<Bytes>& all, ByteSpan mine, int root)
{
    if (rank_ != root) return sendWithSize(mine, root);
    std::vector<MPI_Request> requests;
    for (int r = 0; r < size_; ++r)
        if (r != root) receiveWithSize(all[std::size_t(r)], r, requests);
    all[std::size_t(root)].assign(mine.begin(), mine.end());
    waitAll(requests, {});
}

std::vector<Bytes> MpiCommunicator::doAllGather(ByteSpan mine)
{
    const auto count = std::int64_t(mine.size());
    std::vector<std::int64_t> counts(std::size_t(size_), 0);
    check(MPI_Allgather(&count, 1, MPI_INT64_T, counts.data(), 1, MPI_INT64_T, comm_), "MPI_Allgather");
    std::vector<Bytes> all(counts.size());

    const std::int64_t total = std::accumulate(counts.begin(), counts.end(), std::int64_t(0));
    if (total > chunkBytes_) {  // Its offsets would not fit MPI_Allgatherv's ints.
        for (int r = 0; r < size_; ++r) {
            Bytes& given = all[std::size_t(r)];
            given.resize(std::size_t(counts[std::size_t(r)]));
            if (r == rank_) std::copy(mine.begin(), mine.end(), given.begin());
            broadcastInChunks(given, r);
        }
        return all;
    }
    const std::vector<int> lengths(counts.begin(), counts.end());
    std::vector<int> offsets(lengths.size(), 0);
    std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
    Bytes together(static_cast<std::size_t>(total));
    check(MPI_Allgatherv(mine.data(), int(count), MPI_BYTE, together.data(), lengths.data(), offsets.data(), MPI_BYTE,
                         comm_),
          "MPI_Allgatherv");
    for (std::size_t r = 0; r < all.size(); ++r)
        all[r].assign(together.begin() + offsets[r], together.begin() + offsets[r] + lengths[r]);
    return all;
}

std::vector<std::int64_t> MpiCommunicator::doAllToAll(const std::vector<std::int64_t>& toRank)
{
    std::vector<std::int64_t> fromRank(toRank.size());
    check(MPI_Alltoall(toRank.data(), 1, MPI_INT64_T, fromRank.data(), 1, MPI_INT64_T, comm_), "MPI_Alltoall");
    return fromRank;
}

/// Memory of the host's first rank, as this one sees it. Null on all of them where there is no room for it: it lies in
/// /dev/shm mostly, which containers keep small. A process that writes beyond its end is killed.
std::byte* MpiCommunicator::allocateOnHost(std::size_t bytes, MPI_Win& window) const
{
    constexpr double kLeaveFree = 0.1;
    int room = 1;
    struct statvfs space {};
    if (rankOnHost_ == 0 && statvfs("/dev/shm", &space) == 0)
        room = (1 - kLeaveFree) * double(space.f_bavail) * double(space.f_frsize) > double(bytes);
    check(MPI_Bcast(&room, 1, MPI_INT, 0, host_), "MPI_Bcast");
    if (!room) return nullptr;
    void* mine = nullptr;
    const MPI_Aint own = rankOnHost_ == 0 ? MPI_Aint(bytes) : 0;
    int failed = MPI_Win_allocate_shared(own, 1, MPI_INFO_NULL, host_, &mine, &window) != MPI_SUCCESS;
    check(MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, host_), "MPI_Allreduce");
    if (failed) return nullptr;
    MPI_Aint size = 0;
    int unit = 1;
    check(MPI_Win_shared_query(window, 0, &size, &unit, &mine), "MPI_Win_shared_query");
    return static_cast<std::byte*>(mine);
}

/// Frees what no rank uses of the memory that they share; or all of it, at the end.
void MpiCommunicator::freeUnused(bool all)
{
    std::vector<int> used;
    for (const Shared& shared : shared_) used.push_back(!all && shared.users.use_count() > 1);
    if (used.empty()) return;
    if (!all)
        check(MPI_Allreduce(MPI_IN_PLACE, used.data(), int(used.size()), MPI_INT, MPI_MAX, host_), "MPI_Allreduce");
    std::vector<Shared> left;
    for (std::size_t i = 0; i < shared_.size(); ++i) {
        if (used[i])
            left.push_back(shared_[i]);
        else
            MPI_Win_free(&shared_[i].window);
    }
    shared_.swap(left);
}

std::shared_ptr<const void> MpiCommunicator::doShareOnHost(std::shared_ptr<const void> mine, std::size_t bytes)
{
    constexpr std::size_t kPad = 64, kCopyAtOnce = std::size_t(1) << 22;  // Gathers may read past the end.
    freeUnused(false);
    auto count = std::int64_t(bytes);
    check(MPI_Bcast(&count, 1, MPI_INT64_T, 0, host_), "MPI_Bcast");
    bytes = std::size_t(count);
    Shared shared{MPI_WIN_NULL, std::make_shared<char>()};
    if (std::byte* all = allocateOnHost(bytes + kPad, shared.window)) {
        check(MPI_Win_fence(0, shared.window), "MPI_Win_fence");
        const auto* from = static_cast<const std::byte*>(mine.get());
        if (rankOnHost_ == 0)  // New pages take more time than the copy, so threads share them.
            parallelRanges(bytes, kCopyAtOnce, [&](std::size_t begin, std::size_t end) {
                std::copy(from + begin, from + end, all + begin);
            });
        check(MPI_Win_fence(0, shared.window), "MPI_Win_fence");
        shared_.push_back(shared);
        return std::shared_ptr<const void>(shared.users, all);
    }
    const auto copy = std::make_shared<Bytes>(bytes + kPad);
    if (rankOnHost_ == 0) std::copy_n(static_cast<const std::byte*>(mine.get()), bytes, copy->data());
    forEachChunk(bytes, [&](std::size_t at, int some) {
        check(MPI_Bcast(copy->data() + at, some, MPI_BYTE, 0, host_), "MPI_Bcast");
    });
    return std::shared_ptr<const void>(copy, copy->data());
}

}  // namespace

std::unique_ptr<Communicator> makeMpiCommunicator(std::int64_t chunkBytes, const void* callers)
{
    return std::make_unique<MpiCommunicator>(chunkBytes, callers);
}

}  // namespace aeolic
