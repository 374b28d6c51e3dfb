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

#include "data/progress.h"

namespace aeolic {

/// The steps of one series that are in memory: those in use, and at most one that another thread reads ahead. A step is
/// known by its key, whatever number its loader understands. One thread at a time may call it.
template <class Step>
class StepStore {
public:
    using Load = std::function<std::shared_ptr<const Step>(double key, const ProgressReport&)>;

    /// `load` is called from other threads too, never twice at once for the same key.
    explicit StepStore(Load load) : load_(std::move(load)) {}

    void put(double key, std::shared_ptr<const Step> step) { held_[key] = std::move(step); }

    /// Drops all steps but these, then loads those that are missing. Never more than one other step is in memory: the
    /// one that is read ahead. Throws what loading throws; the next call tries again. Returns whether any was loaded.
    bool hold(const std::vector<double>& keys, const ProgressReport& progress)
    {
        const auto wanted = [&](double key) { return std::find(keys.begin(), keys.end(), key) != keys.end(); };
        std::erase_if(held_, [&](const auto& item) { return !wanted(item.first); });
        bool loaded = false;
        for (const double key : keys) {
            if (held_.contains(key)) continue;
            loaded = true;
            if (ahead_ && ahead_->key != key && !wanted(ahead_->key))
                ahead_.reset();  // Waits until it is read: two steps at once are too many.
            if (ahead_ && ahead_->key == key) {
                std::future<std::shared_ptr<const Step>> step = std::move(ahead_->step);
                ahead_.reset();
                held_[key] = step.get();
            } else {
                held_[key] = load_(key, progress);
            }
        }
        return loaded;
    }

    bool holds(double key) const { return held_.contains(key); }

    /// One of the steps held.
    const std::shared_ptr<const Step>& at(double key) const { return held_.at(key); }

    /// Begins to load the first of these steps that is not held on a thread of its own, unless one is being loaded. An
    /// error is kept until the step is asked for.
    void readAhead(const std::vector<double>& keys)
    {
        const auto missing = std::find_if(keys.begin(), keys.end(), [&](double key) { return !held_.contains(key); });
        if (missing == keys.end()) return;
        const double key = *missing;
        if (ahead_ && (ahead_->key == key || !ahead_->done())) return;
        ahead_.reset();
        const int threads = std::max(1, tbb::this_task_arena::max_concurrency() / 2);  // The frame has the others.
        ahead_.emplace(Ahead{key, std::async(std::launch::async, [this, key, threads] {
                                 std::shared_ptr<const Step> step;
                                 tbb::task_arena arena(threads);
                                 arena.execute([&] { step = load_(key, {}); });
                                 return step;
                             })});
    }

    std::size_t held() const { return held_.size() + (ahead_ ? 1 : 0); }

private:
    struct Ahead {
        double key;
        std::future<std::shared_ptr<const Step>> step;  // Its destructor waits.
        bool done() const { return step.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
    };

    Load load_;
    std::map<double, std::shared_ptr<const Step>> held_;
    std::optional<Ahead> ahead_;  // Last: its thread uses the others.
};

}  // namespace aeolic
