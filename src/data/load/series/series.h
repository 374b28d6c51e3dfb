#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "data/load/scene_sources.h"
#include "data/load/series/step_store.h"

namespace aeolic {

/// One source over time: where its steps lie, those that are in memory, and the two on either side of a moment. A
/// source that does not change has one step, which need not be kept.
template <class Step>
class Series {
public:
    using Pointer = std::shared_ptr<const Step>;

    /// `track` has to last as long as this. `load`: StepStore's.
    Series(const Track& track, typename StepStore<Step>::Load load) : track_(track), steps_(std::move(load)) {}

    /// Local. Brings the steps around a moment into memory, and drops others. Returns whether any was loaded.
    bool hold(const Around& around, const ProgressReport& progress)
    {
        return track_.moves() && steps_.hold(around.keys(), progress);
    }

    /// Collective. Makes the steps that all ranks have of those just read: complete(step) for each that is not yet.
    /// Where that fails the data that were read are used up, and no step is held.
    template <class Complete>
    void complete(const Around& around, const Complete& complete)
    {
        for (const double key : around.keys()) {
            if (!steps_.holds(key) || steps_.at(key)->complete) continue;
            Step step = *steps_.at(key);
            try {
                complete(step);
            } catch (...) {
                forget();
                throw;
            }
            put(key, std::move(step));
        }
    }

    /// Local. The steps on either side of a moment, which are held; the same twice where the moment is one of a step.
    std::pair<const Step*, const Step*> at(const Around& around) const
    {
        return {steps_.at(around.first).get(), steps_.at(around.second).get()};
    }

    /// Local. Begins to read, on another thread, one step around a moment that is not in memory.
    void readAhead(const Around& around)
    {
        if (track_.moves()) steps_.readAhead(around.keys());
    }

    bool holds(double key) const { return steps_.holds(key); }
    const Pointer& step(double key) const { return steps_.at(key); }
    void put(double key, Step&& step) { put(key, std::make_shared<const Step>(std::move(step))); }
    void put(double key, Pointer step) { steps_.put(key, std::move(step)); }
    void forget() { steps_.hold({}, {}); }

    /// How many steps are in memory, with one that is being read.
    std::size_t held() const { return steps_.held(); }

private:
    const Track& track_;
    StepStore<Step> steps_;  // Last: its thread uses the others.
};

}  // namespace aeolic
