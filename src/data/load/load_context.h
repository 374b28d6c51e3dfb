#pragma once

#include <functional>
#include <memory>

#include "data/load/agreement.h"
#include "data/load/load_steps.h"
#include "data/load/series/series.h"
#include "data/load/split.h"

namespace aeolic {

/// What the surfaces of a scene share while they are loaded.
struct LoadContext {
    LoadContext(const SceneDescription& description, const Data& memory, const Split& split, Agreement& agreement);

    /// The field's step, whether it changes or not.
    const std::shared_ptr<const FieldStep>& fieldStep(double key) const
    {
        return fields.holds(key) ? fields.step(key) : onlyStep;
    }
    /// The only step of a field that surfaces may be looked up in again. The caller's memory is not read later.
    void keepStep(const std::shared_ptr<const FieldStep>& step);
    bool dealsToBricks() const { return split.field && split.surface; }

    /// Collective. Runs what reads files. Where each rank has its own part an error says which rank it was.
    void read(const std::function<void()>& action)
    {
        if (split.any())
            agreement.together(action);
        else
            agreement.readTogether(action);
    }

    /// Collective. The field's steps that were read, as all ranks have them.
    void completeSteps(const Around& around);

    const Split split;
    Agreement& agreement;
    StepReader reader;
    SceneSources& sources = reader.sources;
    const SceneDescription& description = reader.description;
    std::shared_ptr<const FieldStep> onlyStep;  ///< Of a field that stays and is looked up in surfaces that change.
    Series<FieldStep> fields;                   ///< Last: its thread uses the reader.
};

}  // namespace aeolic
