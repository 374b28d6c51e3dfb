#include "cluster/field_composite.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "base/parallel.h"

namespace aeolic {
namespace {

struct Run {
    std::uint16_t x0, x1;
};

/// Rows that a rank needs and a brick is seen in: where the message begins, and for how many rows.
struct MessageRows {
    std::int32_t y0, y1;
};

template <class T>
void append(Bytes& bytes, const T* values, std::size_t count)
{
    const auto* from = reinterpret_cast<const std::byte*>(values);
    bytes.insert(bytes.end(), from, from + count * sizeof(T));
}

/// Reads a message in order; throws where it ends too early.
class Reader {
public:
    Reader(const Bytes& bytes, int sender) : bytes_(bytes), sender_(sender) {}

    void read(void* to, std::size_t bytes)
    {
        if (at_ + bytes > bytes_.size())
            throw std::runtime_error("pixels from rank " + std::to_string(sender_) + " end too early");
        std::memcpy(to, bytes_.data() + at_, bytes);
        at_ += bytes;
    }

private:
    const Bytes& bytes_;
    int sender_;
    std::size_t at_ = 0;
};

void appendRow(const FieldPixels& pixels, int y, bool withScalar, std::vector<Run>& runs, Bytes& bytes)
{
    const std::uint32_t* flow = pixels.flow.row(y);
    const float* scalar = withScalar ? pixels.scalar.row(y) : nullptr;
    const auto holds = [&](int x) { return flow[x] != 0 || (scalar && scalar[x] == scalar[x]); };
    runs.clear();
    for (int x = pixels.drawn.x0; x < pixels.drawn.x1; ++x) {
        if (!holds(x)) continue;
        const int begin = x;
        while (x < pixels.drawn.x1 && holds(x)) ++x;
        runs.push_back({std::uint16_t(begin), std::uint16_t(x)});
    }
    const auto count = std::uint16_t(runs.size());
    append(bytes, &count, 1);
    append(bytes, runs.data(), runs.size());
    for (const Run& run : runs) append(bytes, flow + run.x0, std::size_t(run.x1 - run.x0));
    for (const Run& run : runs)
        if (scalar) append(bytes, scalar + run.x0, std::size_t(run.x1 - run.x0));
}

Bytes pixelsFor(const Extent& rows, const FieldPixels& pixels, bool withScalar)
{
    const MessageRows range{std::max(rows.y0, pixels.drawn.y0), std::min(rows.y1, pixels.drawn.y1)};
    Bytes bytes;
    if (rows.empty() || pixels.drawn.empty() || range.y0 >= range.y1) return bytes;
    append(bytes, &range, 1);
    std::vector<Run> runs;
    for (int y = range.y0; y < range.y1; ++y) appendRow(pixels, y, withScalar, runs, bytes);
    return bytes;
}

void takePixels(const Message& message, const Extent& rows, const FieldRows& into)
{
    Reader reader(message.bytes, message.rank);
    MessageRows range{};
    reader.read(&range, sizeof range);
    std::vector<Run> runs;
    for (int y = range.y0; y < range.y1; ++y) {
        std::uint16_t count = 0;
        reader.read(&count, sizeof count);
        runs.resize(count);
        reader.read(runs.data(), count * sizeof(Run));
        for (const Run& run : runs)
            if (!rows.contains(run.x0, y) || run.x1 <= run.x0 || run.x1 > rows.x1)
                throw std::runtime_error("rank " + std::to_string(message.rank) + " sent pixels of other rows");
        for (const Run& run : runs) reader.read(&into.flow->at(run.x0, y), std::size_t(run.x1 - run.x0) * 4);
        for (const Run& run : runs)
            if (into.scalar) reader.read(&into.scalar->at(run.x0, y), std::size_t(run.x1 - run.x0) * 4);
    }
}

}  // namespace

void compositeField(Communicator& communicator, const FieldPixels& mine, const std::vector<Extent>& rowsOf,
                    const FieldRows& into, BusyClock& busy)
{
    std::vector<Message> outgoing(rowsOf.size());
    parallelFor(rowsOf.size(), [&](std::size_t r) {
        outgoing[r] = {int(r), pixelsFor(rowsOf[r], mine, into.scalar != nullptr)};
    });
    busy.stop();
    const std::vector<Message> incoming = communicator.exchange(std::move(outgoing));
    busy.start();
    const Extent& rows = rowsOf[std::size_t(communicator.rank())];
    parallelFor(incoming.size(), [&](std::size_t i) { takePixels(incoming[i], rows, into); });
}

}  // namespace aeolic
