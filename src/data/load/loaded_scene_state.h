#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/cells/near_wall.h"
#include "data/load/blank_surface.h"
#include "data/load/load_steps.h"
#include "data/load/loaded_scene.h"
#include "data/load/scene_facts.h"
#include "data/load/step_store.h"

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

    // The first moment.
    void takeFirstSurface(LoadedSurface&& surface, const PieceFacts& ofAll);  // Local.
    void takeFirstField(const std::shared_ptr<const FieldStep>& step);        // Local.
    std::shared_ptr<const FieldStep> readFirstField(const ProgressReport&);   // Local.

    // A field that is looked up in its own cells (cells_on_surface.cpp).
    bool looksUpUniform(const FieldStep& step);                                   // Collective.
    bool isMostlyBlank();                                                         // Collective.
    void findFieldSide(const FieldStep& step);                                    // Collective.
    void lookUpFirst(const std::shared_ptr<const FieldStep>& step);               // Collective.
    std::shared_ptr<const VolumeSampler> samplerOf(const FieldStep& step) const;  // Local.
    void refine(SurfaceMesh& mesh, const VolumeSampler& sampler);                 // Collective.
    template <class Look, class Take>
    void lookAt(const SurfaceMesh& mesh, const FieldStep& step, const Look& look, const Take& take);  // Collective.
    WallValues nearWall(const SurfaceMesh& mesh, const FieldStep& step, const WallLookup& lookup);    // Collective.
    WallValues lookUp(SurfaceMesh& mesh, const FieldStep& first, const FieldStep& second,
                      double weight);                                        // Collective.
    std::uint64_t lookUpAt(SurfaceMesh& mesh, const Around& around);         // Collective.
    void takeSurface(LoadedSurface&& surface);                               // Local.
    void uniteFirst();                                                       // Collective.
    void measureAll();                                                       // Collective.
    void warnOfBlanks(std::int64_t area);                                    // Collective.
    BlankAreas blankAreas(const std::vector<char>& within);                  // Collective.
    void requireTriangles(std::vector<CutFacts> mine, std::uint64_t drawn);  // Collective.
    void requireOverlap();                                                   // Collective.
    void place(LoadedSurface& piece, const PieceFacts& ofAll) const;         // Local.

    // Other moments.
    bool hold(const Moment& moment, const ProgressReport& progress);                                 // Local.
    void placePieces(const Moment& moment);                                                          // Collective.
    SceneChange show(const Moment& moment, SceneChange change);                                      // Collective.
    std::pair<const LoadedSurface*, const LoadedSurface*> surfaceSteps(const Moment& moment) const;  // Local.
    LoadedSurface surfaceAt(const Moment& moment, bool interpolable);                                // Local.
    void showField(const Around& around);                                                            // Local.
    void warnOnce(bool& warned, const Track& track, const char* what);                               // Local.

    /// Keeps what there was, without its values.
    void forgetMemory();  // Local.

    bool dealsToBricks() const { return split.field && split.surface; }
    bool moves() const { return times.size() > 1; }

    const Split split;
    Agreement& agreement;
    StepReader reader;
    SceneSources& sources = reader.sources;
    const SceneDescription& description = reader.description;
    Scene scene;
    std::vector<double> times;
    std::optional<Moment> shown;  ///< Nothing where going to a moment failed half-way.

    CutFacts firstCut;              ///< The first moment's isosurface.
    glm::dvec3 originWorld{0};      ///< The first moment's, for all others.
    Bounds fieldBox;                ///< Of a field that is looked up in its own cells.
    double fieldSide = 1;           ///< On which side of the surface it is: WallLookup::side.
    bool meetsCells = false;        ///< Some point of the surface is in it at the first moment.
    std::vector<char> withinField;  ///< [points] Which of the surface's are in it at the first moment.
    bool inCells = false;           ///< The field is looked up in its own cells, and the surface carries what it has.
    std::shared_ptr<const FieldStep> onlyStep;  ///< That field, where it stays and the surface may change.
    SurfaceMesh plainSurface;   ///< Where that field may change, and the surface may not: the surface alone.
    std::string surfaceScalar;  ///< Label of the array to colour by that the surface carries, or empty.
    bool warnedSurface = false, warnedField = false;
    std::shared_ptr<GridField> vectorsBetween, scalarBetween;  ///< Memory used again from moment to moment.

    StepStore<LoadedSurface> surfaces;  // Last: their threads use the others.
    StepStore<FieldStep> fields;
};

}  // namespace aeolic
