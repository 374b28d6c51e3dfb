#include "rates/gather_rate.h"

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>

#include "base/parallel.h"
#include "base/timing.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rates/gather_rate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"

#ifndef AEOLIC_GATHER_PATTERN
#define AEOLIC_GATHER_PATTERN
namespace aeolic::cpu {
constexpr int kRowStride = 832;  // An image 800 wide has it. A power of two would make rows share cache sets.
constexpr int kTraceSteps = 128;
constexpr int kTracesPerChunk = 256;
}  // namespace aeolic::cpu
#endif

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Walks the pattern over `records` (a power of two) records, from record `first` on, and xors what fetch(index) brings.
template <class Fetch>
HWY_INLINE std::uint32_t walkPattern(std::size_t first, std::size_t records, const Fetch& fetch)
{
    const hn::ScalableTag<std::uint32_t> du;
    const hn::RebindToSigned<decltype(du)> di;
    const auto mask = hn::Set(di, std::int32_t(records - 1));
    const auto right = hn::Set(di, 1), down = hn::Set(di, kRowStride);
    auto sum = hn::Zero(du);
    for (int trace = 0; trace < kTracesPerChunk; ++trace) {
        const std::size_t start = (first + std::size_t(trace) * hn::Lanes(di)) & (records - 1);
        auto index = hn::And(hn::Iota(di, std::int32_t(start)), mask);
        for (int step = 0; step < kTraceSteps; step += 2) {
            sum = hn::Xor(sum, fetch(index));
            index = hn::And(hn::Add(index, right), mask);
            sum = hn::Xor(sum, fetch(index));
            index = hn::And(hn::Add(index, down), mask);
        }
    }
    return hn::GetLane(hn::SumOfLanes(du, sum));
}

std::uint32_t gatherChunk(const std::uint32_t* words, std::size_t chunk)
{
    const hn::ScalableTag<std::uint32_t> du;
    const std::size_t first = chunk * kTracesPerChunk * hn::Lanes(du);
    return walkPattern(first, kGatherSetBytes / 4,
                       [&](auto index) AEOLIC_INLINE { return hn::GatherIndex(du, words, index); });
}

std::uint32_t blockChunk(const std::uint32_t* words, std::size_t chunk)
{
    const hn::ScalableTag<std::uint32_t> du;
    const std::size_t first = chunk * kTracesPerChunk * hn::Lanes(du);
    return walkPattern(first, kGatherSetBytes / 16, [&](auto index) AEOLIC_INLINE {
        const auto block = loadBlocks<4>(du, words, index);
        return hn::Xor(hn::Xor(block.a, block.b), hn::Xor(block.c, block.d));
    });
}

std::size_t vectorLanes()
{
    return hn::Lanes(hn::ScalableTag<std::uint32_t>());
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(gatherChunk);
HWY_EXPORT(blockChunk);
HWY_EXPORT(vectorLanes);

namespace {

constexpr std::size_t kChunksPerThread = 16;  // A millisecond or two: a shorter run is likelier to be undisturbed.

std::atomic<std::uint32_t> sink;  // Somebody might read it, so that the compiler leaves no work out.

// `body(chunk)` fetches `lanesPerChunk` lanes.
template <class Body>
LaneRate laneRate(int threads, int repeats, double lanesPerChunk, const Body& body)
{
    const auto time = [&](std::size_t chunks, bool parallel) {
        StopWatch watch;
        if (parallel)
            parallelFor(chunks, body);
        else
            for (std::size_t i = 0; i < chunks; ++i) body(i);
        return watch.lapMs();
    };
    const std::size_t chunks = kChunksPerThread * std::size_t(threads);
    time(chunks, true);  // Wakes the threads and fills their caches.
    double oneMs = std::numeric_limits<double>::infinity(), allMs = oneMs;
    for (int i = 0; i < repeats; ++i) {
        oneMs = std::min(oneMs, time(kChunksPerThread, false));
        allMs = std::min(allMs, time(chunks, true));
    }
    return {lanesPerChunk * double(kChunksPerThread) / (oneMs * 1e-3), lanesPerChunk * double(chunks) / (allMs * 1e-3)};
}

}  // namespace

GatherRates measureGatherRates(int threads, int repeats)
{
    const auto words = hwy::AllocateAligned<std::uint32_t>(kGatherSetBytes / 4);
    for (std::size_t i = 0; i < kGatherSetBytes / 4; ++i) words[i] = std::uint32_t(i * 2654435761u);
    const double fetches = double(kTracesPerChunk) * kTraceSteps * double(HWY_DYNAMIC_DISPATCH(vectorLanes)());
    const auto gather = [&](std::size_t chunk) { sink ^= HWY_DYNAMIC_DISPATCH(gatherChunk)(words.get(), chunk); };
    const auto blocks = [&](std::size_t chunk) { sink ^= HWY_DYNAMIC_DISPATCH(blockChunk)(words.get(), chunk); };
    return {laneRate(threads, repeats, fetches, gather), laneRate(threads, repeats, fetches * 4, blocks)};
}

}  // namespace aeolic::cpu
#endif
