#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "base/start_folder.h"
#include "data/load/series/time_series.h"
#include "data/part_choice.h"
#include "description/scene_surfaces.h"

namespace aeolic {

/// One source of data over time. Every step has a key: the number of a file's step, or the moment itself where the
/// source is built in.
struct Track {
    std::string name;           ///< As the user wrote it.
    TimeSeries series;          ///< Files; empty where it is built in.
    std::vector<double> times;  ///< Moments to choose from; none or one: it does not change.
    bool anyMoment = false;     ///< Built in: it can be had at any moment.
    std::size_t firstStep = 0;  ///< Of a file: the one that is read first, because it has the arrays asked for.

    bool moves() const { return times.size() > 1; }
    Around around(double moment) const
    {
        if (!moves()) return {};
        return anyMoment ? Around{moment, moment, 0} : bracketOf(times, moment);
    }
    const StepFile& file(double key) const { return series.steps[std::size_t(key)]; }
    double firstKey() const { return anyMoment && moves() ? times.front() : double(firstStep); }

    /// A single file has been opened, and these are its steps.
    void takeStepsOf(const std::vector<double>& timeSteps);
    /// Names its files so that they are found from any folder.
    void keepFolder(const StartFolder& folder);
};

/// A field's file, and which parts of it, where files of its kind have some to choose from.
FileAndParts splitField(const std::string& spec);

/// Steps of surfaces and field around a moment.
struct Moment {
    std::vector<Around> surfaces;
    Around field;
    bool operator==(const Moment&) const = default;
};

/// One of a scene's surfaces, and where it comes from.
struct SurfaceTrack {
    SurfaceItem item;
    SurfaceSpec spec;
    Track track;  ///< Nothing where it is cut out of the field.
};

/// Where a scene's surfaces and field come from.
struct SceneSources {
    std::vector<SurfaceTrack> surfaces;  ///< One at least.
    Track field;

    /// Looks for files and reads lists of them, but opens none. Throws InputError for a series that makes no sense.
    explicit SceneSources(const SceneDescription& description);

    bool moves(const SurfaceTrack& surface) const
    {
        return surface.spec.isCut() ? field.moves() : surface.track.moves();
    }
    Moment around(double moment) const;

    /// The first and the last moment that there are: outside of them the nearest of these is shown. Nothing where any
    /// moment can be had, or nothing changes.
    std::optional<std::array<double, 2>> span() const;

    /// All steps of surfaces and field, sorted; empty where none changes.
    std::vector<double> times() const;
};

}  // namespace aeolic
