#pragma once

#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "data/load/time_series.h"
#include "data/part_choice.h"
#include "description/surface_spec.h"

namespace aeolic {

/// One source of data over time. Every step has a key: the number of a file's step, or the moment itself where the
/// source is built in.
struct Track {
    std::string name;           ///< As the user wrote it.
    TimeSeries series;          ///< Files; empty where it is built in.
    std::vector<double> times;  ///< Moments to choose from; none or one: it does not change.
    bool anyMoment = false;     ///< Built in: it can be had at any moment.

    bool moves() const { return times.size() > 1; }
    Around around(double moment) const
    {
        if (!moves()) return {};
        return anyMoment ? Around{moment, moment, 0} : bracketOf(times, moment);
    }
    const StepFile& file(double key) const { return series.steps[std::size_t(key)]; }
    double firstKey() const { return anyMoment && moves() ? times.front() : 0; }

    /// A single file has been opened, and these are its steps.
    void takeStepsOf(const std::vector<double>& timeSteps);
};

/// A field's file, and which parts of it: only an EnSight case has some to choose from.
FileAndParts splitField(const std::string& spec);

/// Steps of surface and field around a moment.
struct Moment {
    Around surface, field;
    bool operator==(const Moment&) const = default;
};

/// Where a scene's surface and field come from.
struct SceneSources {
    SurfaceSpec surfaceSpec;
    Track surface, field;

    /// Looks for files and reads lists of them, but opens none. Throws InputError for a series that makes no sense.
    explicit SceneSources(const SceneDescription& description);

    bool surfaceMoves() const { return surfaceSpec.isCut() ? field.moves() : surface.moves(); }
    Moment around(double moment) const { return {surface.around(moment), field.around(moment)}; }

    /// All steps of surface and field, sorted; empty where neither changes.
    std::vector<double> times() const;
};

}  // namespace aeolic
