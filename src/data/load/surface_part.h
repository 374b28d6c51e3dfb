#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/cells/near_wall.h"
#include "data/load/agreement.h"
#include "data/load/blank_surface.h"
#include "data/load/load_steps.h"
#include "data/load/scene_facts.h"
#include "data/load/series/step_store.h"
#include "data/load/split.h"
#include "data/scene.h"

namespace aeolic {

/// What the surfaces of a scene share while they are loaded.
struct LoadContext {
    LoadContext(const SceneDescription& description, const Data& memory, const Split& split, Agreement& agreement);

    /// The field's step, whether it changes or not.
    const std::shared_ptr<const FieldStep>& fieldStep(double key) const
    {
        return fields.holds(key) ? fields.at(key) : onlyStep;
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
    StepStore<FieldStep> fields;                ///< Last: its thread uses the reader.
};

/// The field at the moment shown, where it is sampled at every pixel.
struct ShownField {
    std::shared_ptr<const GridField> vectors, scalar;
};

/// "NAME: its steps are WHAT: between two the earlier one is shown".
std::string earlierIsShown(const std::string& name, const char* what);

/// One of a scene's surfaces: its own small scene, and its steps. A scene of one surface is that of its only part.
/// Whoever calls one part calls all, in the same order on every rank. Its first moment is in surface_part.cpp, all
/// others are in surface_moments.cpp, and a field's values on its points in cells_on_surface.cpp.
class SurfacePart {
public:
    SurfacePart(LoadContext& context, std::size_t index);

    // The first moment, in this order.
    LoadedSurface readFirst(const ProgressReport& progress);               // Local. Unless it is a cut.
    void takeFirst(LoadedSurface&& surface, const PieceFacts& ofAll);      // Local. Unless it is a cut.
    void takeFirstField(const FieldStep& step);                            // Local. Where there is a field.
    void lookUpWhereNeeded(const std::shared_ptr<const FieldStep>& step);  // Collective.
    void unite();                                                          // Collective.

    /// Local. Whether vectors, or the scalar, are sampled at every pixel. Else the surface carries them.
    bool samplesVectors() const { return ask().fieldVectors && scene.field; }
    bool samplesScalar() const { return scalarOfField_ && scene.field; }
    /// Local. Needs the field in any way.
    bool usesField() const { return ask().fieldVectors || scalarOfField_; }
    bool isLookedUp() const { return inCells_; }

    /// Collective. Whether it meets the field's box; that box is then in `box`.
    bool meetsField(Bounds& box) const;
    std::int64_t area() const;             // Local.
    void dealToBricks();                   // Collective. Where surface and field are split.
    void measureScene();                   // Collective.
    void warnOfBlanks(std::int64_t area);  // Collective. `area`: the whole surface's.
    void finish();                         // Local. What is left out becomes warnings.
    bool moves() const { return context_.sources.moves(source()); }

    // Other moments. `next` is prepared before anything changes.
    struct Next {
        SceneChange change;
        bool otherShape = false;  ///< Its data are others, not only what the field has on it.
        LoadedSurface surface;
        std::uint64_t triangles = 0;
        std::optional<GridField> dealtBy;
    };
    bool hold(const Around& around, const ProgressReport& progress);  // Local.
    void place(const Around& around);                                 // Collective: the data just read.
    Next prepare(const Moment& moment, const SceneChange& change);    // Collective.
    SceneChange take(Next&& next, const ShownField& field);           // Collective.
    void readAhead(const Around& around);                             // Local.
    void readMemory(const ProgressReport& progress);                  // Local. Other data in memory.
    void forgetMemory() { steps_.hold({}, {}); }                      // Local.

    /// Local. What is left out of the data that are shown now, to be warned of. Between the two the scene has these
    /// data's own ranges and no other warnings.
    void beginWarnings(const std::vector<Tally>& ofField);
    void endWarnings();
    const std::vector<std::string>& told() const { return told_; }  ///< Warnings of the data.

    std::size_t held() const { return steps_.held(); }  // Local.

    SurfaceTrack& source() const { return context_.sources.surfaces[index_]; }
    SurfaceAsk& ask() const { return context_.reader.asks[index_]; }
    std::size_t index() const { return index_; }

    Scene scene;

private:
    bool isCut() const { return source().spec.isCut(); }
    const Around& aroundOf(const Moment& moment) const { return isCut() ? moment.field : moment.surfaces[index_]; }
    void takeSurface(LoadedSurface&& surface);
    void placePiece(LoadedSurface& piece, const PieceFacts& ofAll) const;
    void requireTriangles(std::vector<CutFacts> mine, std::uint64_t drawn);
    BlankAreas blankAreas(const std::vector<char>& within);
    std::pair<const LoadedSurface*, const LoadedSurface*> stepsAround(const Moment& moment) const;
    LoadedSurface surfaceAt(const Moment& moment, bool interpolable);

    // A field that is looked up on the surface's points (cells_on_surface.cpp). All of it is Collective.
    struct Volume {
        const FieldStep* step;
        std::shared_ptr<const VolumeSampler> sampler;
        std::shared_ptr<const LeftOut> leftOut;  // CellVolume::Shell's.
    };
    Volume volumeAround(SurfaceZone zone, const FieldStep& step, double diagonals);
    double diagonalsAtOnce(const FieldStep& step) const;  // Local.
    Volume volumeAt(const SurfaceMesh& mesh, const FieldStep& step);
    Volume volumeToLookUp(const SurfaceMesh& mesh, Volume touching);
    bool looksUpUniform(const FieldStep& step);
    bool isMostlyBlank();
    void findFieldSide(const SurfaceMesh& mesh, const Volume& volume);
    void lookUpFirst(const std::shared_ptr<const FieldStep>& step);
    void refine(SurfaceMesh& mesh, const Volume& volume);
    template <class Look, class Take>
    void lookAt(const SurfaceMesh& mesh, const Volume& volume, const Look& look, const Take& take);
    WallValues nearWall(const SurfaceMesh& mesh, const Volume& volume, const WallLookup& lookup);
    void lookFarther(const SurfaceMesh& mesh, const Volume& volume, const WallLookup& lookup, WallValues& all);
    WallValues lookUp(SurfaceMesh& mesh, const Volume& volume, const FieldStep* later, double weight);
    std::uint64_t lookUpAt(SurfaceMesh& mesh, const Around& around);

    LoadContext& context_;
    const std::size_t index_;
    Agreement& agreement_ = context_.agreement;

    /// What measuring changes of a scene, and warnings of other things than its data.
    struct Aside {
        double maxVector = 0;
        std::array<double, 2> scalarRange{}, robustRange{};
        bool scalarRangeKnown = false;
        std::vector<std::string> warnings;
    };

    std::vector<Tally> tallies_;            // Of the surface's data that are shown.
    std::vector<std::string> ownWarnings_;  // The same, of its file alone.
    std::vector<std::string> told_;
    Aside aside_;
    CutFacts firstCut_;          // The first moment's isosurface.
    glm::dvec3 originWorld_{0};  // The first moment's, for all others.
    Bounds fieldBox_;            // Of a field that is looked up on its points.
    double fieldSide_ = 1;       // On which side of the surface it is: WallLookup::side.
    std::optional<double> offsetWorld_ = context_.description.field.offset;
    bool meetsCells_ = false;        // Some point of the surface is in it at the first moment.
    std::vector<char> withinField_;  // [points] Which of the surface's are in it at the first moment.
    bool inCells_ = false;           // The surface carries what the field has.
    bool scalarOfField_ = false;     // What is coloured by is the field's, and the surface was not cut with it.
    SurfaceMesh plainSurface_;       // Where that field may change, and the surface may not: the surface alone.
    std::string ownScalar_;          // Label of the array to colour by that the surface came with, or empty.
    bool warned_ = false;
    StepStore<LoadedSurface> steps_;  // Last: its thread uses the others.
};

}  // namespace aeolic
