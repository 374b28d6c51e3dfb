#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "data/load/scene_sources.h"
#include "data/progress.h"

namespace aeolic {

/// One source over time: where its steps lie, and those that are in memory: those in use, and at most one that another
/// thread reads ahead. A step is known by its key (Track). A source that does not change has one step, which need not
/// be kept. One thread at a time may call it.
template <class Step>
class Series {
public:
    using Pointer = std::shared_ptr<const Step>;
    using Load = std::function<Pointer(double key, const ProgressReport&)>;

    /// `track` has to last as long as this. `load` is called from other threads too, never twice at once for the same
    /// key.
    Series(const Track& track, Load load) : track_(track), load_(std::move(load)) {}

    /// Local. Brings the steps around a moment into memory, and drops all others first. Never more than one other step
    /// is in memory: the one that is read ahead. Throws what loading throws; the next call tries again. Returns whether
    /// any was loaded.
    bool hold(const Around& around, const ProgressReport& progress)
    {
        if (!track_.moves()) return false;
        const std::vector<double> keys = around.keys();
        const auto wanted = [&](double key) { return std::ranges::find(keys, key) != keys.end(); };
        std::erase_if(held_, [&](const auto& item) { return !wanted(item.first); });
        bool loaded = false;
        for (const double key : keys) {
            if (held_.contains(key)) continue;
            loaded = true;
            if (ahead_ && ahead_->key != key && !wanted(ahead_->key))
                ahead_.reset();  // Waits until it is read: two steps at once are too many.
            if (ahead_ && ahead_->key == key) {
                std::future<Pointer> step = std::move(ahead_->step);
                ahead_.reset();
                held_[key] = step.get();
            } else {
                held_[key] = load_(key, progress);
            }
        }
        return loaded;
    }

    /// Collective. Makes the steps that all ranks have of those just read: complete(step) for each that is not yet.
    /// Where that fails the data that were read are used up, and no step is held.
    template <class Complete>
    void complete(const Around& around, const Complete& complete)
    {
        for (const double key : around.keys()) {
            if (!holds(key) || step(key)->complete) continue;
            Step made = *step(key);
            try {
                complete(made);
            } catch (...) {
                forget();
                throw;
            }
            put(key, std::move(made));
        }
    }

    /// Local. The steps on either side of a moment, which are held; the same twice where the moment is one of a step.
    std::pair<const Step*, const Step*> at(const Around& around) const
    {
        return {step(around.first).get(), step(around.second).get()};
    }

    /// Local. Begins to read one step around a moment that is not in memory, on a thread of its own, unless one is
    /// being read. An error is kept until the step is asked for.
    void readAhead(const Around& around)
    {
        const std::vector<double> keys = around.keys();
        const auto missing = std::ranges::find_if(keys, [&](double key) { return !holds(key); });
        if (!track_.moves() || missing == keys.end()) return;
        const double key = *missing;
        if (ahead_ && (ahead_->key == key || !ahead_->done())) return;
        ahead_.reset();
        const int threads = std::max(1, tbb::this_task_arena::max_concurrency() / 2);  // The frame has the others.
        ahead_.emplace(Ahead{key, std::async(std::launch::async, [this, key, threads] {
                                 Pointer step;
                                 tbb::task_arena arena(threads);
                                 arena.execute([&] { step = load_(key, {}); });
                                 return step;
                             })});
    }

    bool holds(double key) const { return held_.contains(key); }
    const Pointer& step(double key) const { return held_.at(key); }
    void put(double key, Step&& step) { put(key, std::make_shared<const Step>(std::move(step))); }
    void put(double key, Pointer step) { held_[key] = std::move(step); }
    void forget() { held_.clear(); }

    /// How many steps are in memory, with one that is being read.
    std::size_t held() const { return held_.size() + (ahead_ ? 1 : 0); }

private:
    struct Ahead {
        double key;
        std::future<Pointer> step;  // Its destructor waits.
        bool done() const { return step.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
    };

    const Track& track_;
    Load load_;
    std::map<double, Pointer> held_;
    std::optional<Ahead> ahead_;  // Last: its thread uses the others.
};

}  // namespace aeolic
