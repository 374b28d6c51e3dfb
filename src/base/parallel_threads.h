#pragma once

/// The parallel loops of parallel.h on plain threads, for the thread sanitizer alone: Debian's oneTBB is not
/// instrumented, so what it synchronises would look like races, and real ones of our loops' bodies would drown among
/// them.

#include <tbb/task.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace aeolic {

template <class Body>
void parallelFor(std::size_t count, const Body& body)
{
    constexpr std::size_t kThreads = 4;
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failureMutex;
    // A loop within a group of tasks that is cancelled skips what it has not begun, as oneTBB's do.
    tbb::task_group_context* const group = tbb::task::current_context();
    const auto isCancelled = [&] { return group && group->is_group_execution_cancelled(); };
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < count && !isCancelled(); i = next++) body(i);
        } catch (...) {
            const std::lock_guard lock(failureMutex);
            failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> helpers;
    for (std::size_t k = 1; k < std::min(kThreads, count); ++k) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
    if (failure) std::rethrow_exception(failure);
}

template <class Body>
void parallelRanges(std::size_t count, std::size_t grain, const Body& body)
{
    // A loop of few threads needs few pieces; thread starts cost more here than in a pool.
    const std::size_t piece = std::max({grain, std::size_t{1}, count / 16});
    parallelFor((count + piece - 1) / piece, [&](std::size_t i) { body(i * piece, std::min((i + 1) * piece, count)); });
}

}  // namespace aeolic
