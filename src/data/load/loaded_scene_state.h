#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "data/load/join_scenes.h"
#include "data/load/loaded_scene.h"
#include "data/load/surface_part.h"
#include "data/reading/reader_pool.h"

namespace aeolic {

/// What LoadedScene knows, for its two halves: the first moment (loaded_scene.cpp) and all others (loaded_moments.cpp).
struct LoadedScene::State {
    State(const SceneDescription& description, const Data& memory, const Split& split, Agreement& agreement);

    /// Collective. The scene at the description's moment.
    void load(const ProgressReport& progress);

    /// Collective. The scene at another moment.
    SceneChange moveTo(double moment, const ProgressReport& progress);

    /// Collective. Other data in memory at that moment.
    SceneChange replace(const Data& memory, double moment, const ProgressReport& progress);

    // The first moment: surfaces and field are read, surfaces are looked up in the field, all is measured.
    std::shared_ptr<const FieldStep> readSources(const ProgressReport& progress);  // Collective.
    std::shared_ptr<const FieldStep> readFirstField(const ProgressReport&);        // Collective.
    void takeFirstField(const std::shared_ptr<const FieldStep>& step);             // Local.
    void lookUpAll(std::shared_ptr<const FieldStep> step);                         // Collective.
    void requireOverlap();                                                         // Collective.
    bool measureFirst(const ProgressReport& progress);                             // Collective.
    void measureAll();                                                             // Collective.
    void takeWarnings(const std::vector<std::int64_t>& areas);                     // Collective.
    void keepTallies(const FieldStep& step);                                       // Local.

    // Other moments.
    bool hold(const Moment& moment, const ProgressReport& progress);  // Local.
    void complete(const Moment& moment);                              // Collective. What hold() has read.
    /// `change`: [surfaces] the sources that have other data.
    SceneChange show(const Moment& moment, const std::vector<SceneChange>& change);  // Collective.
    void showField(const Around& around);                                            // Local.
    void warnAnew();                                                                 // Collective.

    /// Keeps what there was, without its values.
    void forgetMemory();  // Local.
    void forgetSteps();   // Local.

    /// The process may go to another folder before another moment is read.
    void keepFolder();  // Local.

    /// Makes the scene of the surfaces' own ones, where there are several.
    void joinSurfaces();  // Local.
    void joinWarnings();  // Local.

    Scene& scene() { return parts.size() == 1 ? parts.front()->scene : joined; }
    bool moves() const { return times.size() > 1; }
    bool samplesPixels() const;

    KeptReaders readers;  ///< For the files of other moments.
    LoadContext context;
    Agreement& agreement = context.agreement;
    SceneSources& sources = context.sources;
    const SceneDescription& description = context.description;
    std::vector<std::unique_ptr<SurfacePart>> parts;
    std::vector<bool> visible;          ///< [surfaces] Which are drawn.
    std::vector<SceneRanges> measured;  ///< [surfaces] By the first moment, so that nothing jumps.
    StartFolder folder;                 ///< Where the files of all moments are.
    Scene joined;                       ///< Of several surfaces.
    std::vector<double> times;
    std::optional<Moment> shown;  ///< Nothing where going to a moment failed half-way.

    std::vector<Tally> fieldTallies;  ///< Of the field's data that are shown, by the rank that counts them.
    ShownField field;                 ///< At the moment shown.
    bool warnedField = false;
    std::shared_ptr<GridField> vectorsBetween, scalarBetween;  ///< Memory used again from moment to moment.
};

}  // namespace aeolic
