#include "communicator_testing.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "cluster/balance/network_model.h"

namespace aeolic::testkit {
namespace {

/// Collects what does not hold.
struct Findings {
    explicit Findings(Communicator& c) : comm(c) {}

    void expect(bool holds, const std::string& what)
    {
        if (!holds)
            faults.push_back("rank " + std::to_string(comm.rank()) + " of " + std::to_string(comm.size()) + ": " +
                             what);
    }

    Communicator& comm;
    std::vector<std::string> faults;
};

std::size_t lengthOf(int rank)
{
    return std::size_t(rank) * 37 % 101;  // Rank 0 gives nothing: empty contributions are part of every check.
}

void checkBroadcast(Findings& f)
{
    for (int root = 0; root < f.comm.size(); ++root)
        for (const std::size_t length : {std::size_t(0), std::size_t(1), std::size_t(100003)}) {
            Bytes bytes = f.comm.rank() == root ? patternBytes(length, root) : patternBytes(7, -1);
            f.comm.broadcast(bytes, root);
            f.expect(bytes == patternBytes(length, root),
                     "broadcast of " + std::to_string(length) + " bytes from rank " + std::to_string(root));
        }
}

void checkGathers(Findings& f)
{
    const Bytes mine = patternBytes(lengthOf(f.comm.rank()), f.comm.rank());
    for (int root = 0; root < f.comm.size(); ++root) {
        const std::vector<Bytes> all = f.comm.gather(mine, root);
        if (f.comm.rank() != root) {
            f.expect(all.empty(), "gather gives something away from its root");
            continue;
        }
        f.expect(int(all.size()) == f.comm.size(), "gather gives one for every rank");
        for (int r = 0; r < int(all.size()); ++r)
            f.expect(all[std::size_t(r)] == patternBytes(lengthOf(r), r), "gather of rank " + std::to_string(r));
    }
    const std::vector<Bytes> all = f.comm.allGather(mine);
    f.expect(int(all.size()) == f.comm.size(), "allGather gives one for every rank");
    for (int r = 0; r < int(all.size()); ++r)
        f.expect(all[std::size_t(r)] == patternBytes(lengthOf(r), r), "allGather of rank " + std::to_string(r));
    for (const Bytes& nothing : f.comm.allGather({})) f.expect(nothing.empty(), "allGather of nothing");
}

void checkGatherIntoKeptMemory(Findings& f)
{
    std::vector<Bytes> all(f.comm.isRoot() ? 0 : 3);  // On other ranks it stays as it is.
    // Sizes around what the test's MPI sends at once (977 bytes), and a smaller one after larger ones.
    for (const std::size_t length : {977, 100003, 0, 976, 978, 1954, 1}) {
        const auto lengthOf = [&](int rank) { return length + std::size_t(rank % 2); };
        f.comm.gatherInto(all, patternBytes(lengthOf(f.comm.rank()), f.comm.rank()));
        f.expect(int(all.size()) == (f.comm.isRoot() ? f.comm.size() : 3), "gather into memory: one for every rank");
        for (int r = 0; f.comm.isRoot() && r < f.comm.size(); ++r)
            f.expect(all[std::size_t(r)] == patternBytes(lengthOf(r), r),
                     "gather of " + std::to_string(lengthOf(r)) + " bytes of rank " + std::to_string(r));
    }
}

void checkGatherInPlace(Findings& f)
{
    std::vector<std::size_t> lengths;
    Bytes expected;
    for (int r = 0; r < f.comm.size(); ++r) {
        lengths.push_back(lengthOf(r));
        const Bytes given = patternBytes(lengthOf(r), r);
        expected.insert(expected.end(), given.begin(), given.end());
    }
    Bytes all(expected.size());
    const auto before = std::accumulate(lengths.begin(), lengths.begin() + f.comm.rank(), std::size_t{0});
    std::copy_n(expected.begin() + std::ptrdiff_t(before), lengthOf(f.comm.rank()),
                all.begin() + std::ptrdiff_t(before));
    f.comm.allGatherInPlace(all, lengths);
    f.expect(all == expected, "allGather in place gives what every rank gave, in their order");
}

void checkAllToAll(Findings& f)
{
    std::vector<std::int64_t> mine, expected;
    for (int r = 0; r < f.comm.size(); ++r) {
        mine.push_back(1000 * f.comm.rank() + r);
        expected.push_back(1000 * r + f.comm.rank());
    }
    f.expect(f.comm.allToAll(mine) == expected, "allToAll hands everyone its own");
}

void checkReductions(Findings& f)
{
    const int rank = f.comm.rank(), n = f.comm.size();
    f.expect(f.comm.allReduce(std::int64_t(rank), Reduction::sum) == std::int64_t(n) * (n - 1) / 2, "sum of ranks");
    f.expect(f.comm.allReduce(double(rank) - 0.5, Reduction::max) == n - 1.5, "maximum");
    f.expect(f.comm.allReduce(double(rank) - 0.5, Reduction::min) == -0.5, "minimum");

    constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
    std::vector<std::int64_t> whole = {kLargest - rank, -rank, 1};
    f.comm.allReduce(std::span(whole), Reduction::min);
    f.expect(whole == std::vector<std::int64_t>{kLargest - (n - 1), -(n - 1), 1}, "minimum of 64-bit numbers");

    // The sum depends on the order: the ones get lost in 1e16 or not. It must be the order of ranks.
    std::vector<double> terms = {rank == 0 ? 1e16 : 1.0};
    f.comm.allReduce(std::span(terms), Reduction::sum);
    double inRankOrder = 1e16;
    for (int r = 1; r < n; ++r) inRankOrder += 1.0;
    f.expect(terms[0] == inRankOrder, "sum of doubles in rank order");

    std::vector<double> none;
    f.comm.allReduce(std::span(none), Reduction::sum);
}

/// Rank a sends b bytes that tell both apart; every rank sends to itself and its two followers, some messages empty.
void checkExchange(Findings& f, std::size_t scale)
{
    const int rank = f.comm.rank(), n = f.comm.size();
    const auto bytesFromTo = [&](int from, int to) {
        const bool sends = to == from || to == (from + 1) % n || to == (from + 2) % n;
        return patternBytes(sends ? std::size_t((from * 5 + to) % 4) * scale : 0, from * 1000 + to);
    };
    const auto outgoing = [&] {
        std::vector<Message> messages;
        for (int to = n - 1; to >= 0; --to) messages.push_back({to, bytesFromTo(rank, to)});
        return messages;
    };
    std::vector<Message> expected;
    for (int from = 0; from < n; ++from) {
        Bytes bytes = bytesFromTo(from, rank);
        if (!bytes.empty()) expected.push_back({from, std::move(bytes)});
    }
    const auto same = [](const std::vector<Message>& a, const std::vector<Message>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const Message& x, const Message& y) { return x.rank == y.rank && x.bytes == y.bytes; });
    };
    const std::string what = "exchange of up to " + std::to_string(3 * scale) + " bytes";
    f.expect(same(f.comm.exchange(outgoing()), expected), what);
    f.expect(f.comm.exchange({}).empty(), "exchange of nothing");
}

/// Every rank sends every other one two parts of its memory. What it receives must not touch the bytes between.
void checkInPlace(Findings& f, std::size_t scale)
{
    const int rank = f.comm.rank(), n = f.comm.size();
    const auto sizeOf = [&](int from, int to, int part) { return std::size_t((from + 2 * to + part) % 3) * scale; };
    std::vector<Bytes> mine, theirs;
    for (int r = 0; r < n; ++r)
        for (int part = 0; part < 2; ++part) {
            mine.push_back(patternBytes(sizeOf(rank, r, part), rank * 100 + r * 2 + part));
            theirs.push_back(patternBytes(sizeOf(r, rank, part) + 2, -1));
        }
    std::vector<OutgoingBytes> outgoing;
    std::vector<IncomingBytes> incoming;
    for (int i = 0; i < 2 * n; ++i) {
        if (i / 2 == rank) continue;
        outgoing.push_back({i / 2, mine[std::size_t(i)]});
        const std::span<std::byte> whole(theirs[std::size_t(i)]);
        incoming.push_back({i / 2, whole.subspan(1, whole.size() - 2)});
    }
    f.comm.exchangeInPlace(outgoing, incoming);
    for (int i = 0; i < 2 * n; ++i) {
        if (i / 2 == rank) continue;
        Bytes expected = patternBytes(theirs[std::size_t(i)].size(), -1);
        const Bytes sent = patternBytes(sizeOf(i / 2, rank, i % 2), i / 2 * 100 + rank * 2 + i % 2);
        std::copy(sent.begin(), sent.end(), expected.begin() + 1);
        f.expect(theirs[std::size_t(i)] == expected, "exchange in place of up to " + std::to_string(2 * scale));
    }
}

/// Large enough for several chunks; some of it goes before the rest.
void checkShared(Findings& f)
{
    std::vector<std::shared_ptr<const void>> kept;
    for (const std::size_t length : {std::size_t(0), std::size_t(5), std::size_t(300007), std::size_t(4096)}) {
        std::shared_ptr<const void> mine;
        const auto seed = int(length % 97);
        if (f.comm.isFirstOnHost()) {
            const auto bytes = std::make_shared<Bytes>(patternBytes(length, seed));
            mine = std::shared_ptr<const void>(bytes, bytes->data());
        }
        kept.push_back(f.comm.shareOnHost(std::move(mine), f.comm.isFirstOnHost() ? length : 0));
        const auto* all = static_cast<const std::byte*>(kept.back().get());
        const Bytes expected = patternBytes(length, seed);
        f.expect(length == 0 || std::equal(expected.begin(), expected.end(), all),
                 "shared memory of " + std::to_string(length) + " bytes");
        if (length == 5 || (length == 4096 && f.comm.rank() == 0)) kept.erase(kept.begin());
    }
    f.comm.barrier();  // What one rank gave must not end before others have looked at it.
}

void checkPairOnly(Findings& f)
{
    const int last = f.comm.size() - 1;
    if (last == 0) return;
    Bytes bytes = f.comm.rank() == 0 ? patternBytes(9, 1) : Bytes(9);
    if (f.comm.rank() == 0) f.comm.exchangeInPlace({{last, bytes}}, {});
    if (f.comm.rank() == last) f.comm.exchangeInPlace({}, {{0, bytes}});
    if (f.comm.rank() == last) f.expect(bytes == patternBytes(9, 1), "exchange that only two ranks call");
}

void checkTraffic(Findings& f)
{
    const std::int64_t others = f.comm.size() - 1;
    const Traffic none;
    Traffic sentBefore = f.comm.sent(), receivedBefore = f.comm.received();
    const auto expectTraffic = [&](const Traffic& sent, const Traffic& received, const char* what) {
        const auto grewBy = [](const Traffic& now, Traffic& before, const Traffic& expected) {
            const Traffic grown{now.bytes - before.bytes, now.messages - before.messages};
            before = now;
            return grown == expected;
        };
        f.expect(grewBy(f.comm.sent(), sentBefore, sent), std::string("what was sent in ") + what);
        f.expect(grewBy(f.comm.received(), receivedBefore, received), std::string("what was received in ") + what);
    };
    f.comm.barrier();
    expectTraffic({0, others}, {0, others}, "a barrier");
    Bytes bytes(5);
    f.comm.broadcast(bytes);
    if (f.comm.isRoot())
        expectTraffic({5 * others, others}, none, "a broadcast");
    else
        expectTraffic(none, {5, 1}, "a broadcast");
    f.comm.gather(Bytes(3));
    if (f.comm.isRoot())
        expectTraffic(none, {3 * others, others}, "a gather");
    else
        expectTraffic({3, 1}, none, "a gather");
    f.comm.allGather(Bytes(3));
    expectTraffic({3 * others, others}, {3 * others, others}, "an allGather");
    Bytes all(3 * std::size_t(f.comm.size()));
    f.comm.allGatherInPlace(all, std::vector<std::size_t>(std::size_t(f.comm.size()), 3));
    const Traffic handedOn{3 * others, collectiveRounds(f.comm.size())};
    expectTraffic(handedOn, handedOn, "an allGather in place");
    f.comm.exchange({{f.comm.rank(), Bytes(8)}});
    expectTraffic({8 * others, others}, {8 * others, others}, "a message to oneself, but for its announcement");
    const int next = (f.comm.rank() + 1) % f.comm.size();
    f.comm.exchange({{next, Bytes(11)}});
    const Traffic exchanged{others > 0 ? 11 + 8 * others : 0, others > 0 ? 1 + others : 0};
    expectTraffic(exchanged, exchanged, "an exchange");
    if (others == 0) return;
    Bytes there(12);
    const int before = (f.comm.rank() + f.comm.size() - 1) % f.comm.size();
    f.comm.exchangeInPlace({{next, ByteSpan(bytes)}, {next, {}}, {next, ByteSpan(bytes)}},
                           {{before, std::span(there).first(5)}, {before, std::span(there).first(5)}});
    expectTraffic({10, 2}, {10, 2}, "an exchange in place");
}

template <class Error>
bool throws(const std::function<void()>& action)
{
    try {
        action();
    } catch (const Error&) {
        return true;
    }
    return false;
}

void checkMistakes(Findings& f)
{
    const int n = f.comm.size();
    Bytes bytes;
    f.expect(throws<std::logic_error>([&] { f.comm.broadcast(bytes, n); }), "no such root");
    f.expect(throws<std::logic_error>([&] { f.comm.gather(bytes, -1); }), "no such root of a gather");
    f.expect(throws<std::logic_error>([&] { f.comm.exchange({{n, Bytes(1)}}); }), "no such receiver");
    f.expect(throws<std::logic_error>([&] {
                 f.comm.exchange({{0, Bytes(1)}, {0, Bytes(1)}});
             }),
             "two messages to one rank");
    f.expect(throws<std::logic_error>([&] { f.comm.allToAll(std::vector<std::int64_t>(std::size_t(n + 1))); }),
             "allToAll of too many values");
    f.expect(
        throws<std::logic_error>([&] { f.comm.allGatherInPlace(bytes, std::vector<std::size_t>(std::size_t(n), 1)); }),
        "an allGather in place without room");
    Bytes three(3);
    f.expect(throws<std::logic_error>([&] { f.comm.exchangeInPlace({{f.comm.rank(), three}}, {}); }), "to oneself");
    f.expect(throws<std::logic_error>([&] { f.comm.exchangeInPlace({}, {{n, three}}); }), "no such sender");
}

}  // namespace

Bytes patternBytes(std::size_t count, int seed)
{
    Bytes bytes(count);
    for (std::size_t i = 0; i < count; ++i)
        bytes[i] = std::byte((i * 131 + i / 251 + std::size_t(seed) * 29 + 7) & 255);
    return bytes;
}

std::vector<std::string> communicatorFaults(Communicator& communicator)
{
    Findings findings(communicator);
    findings.expect(communicator.rank() >= 0 && communicator.rank() < communicator.size(), "a rank of the group");
    checkBroadcast(findings);
    checkGathers(findings);
    checkGatherIntoKeptMemory(findings);
    checkGatherInPlace(findings);
    checkAllToAll(findings);
    checkReductions(findings);
    checkExchange(findings, 1);
    checkInPlace(findings, 1);
    checkExchange(findings, 100000);  // Longer than what MPI libraries send before the receiver asks.
    checkInPlace(findings, 100000);
    checkShared(findings);
    checkPairOnly(findings);
    checkTraffic(findings);
    checkMistakes(findings);
    communicator.barrier();
    return findings.faults;
}

}  // namespace aeolic::testkit
