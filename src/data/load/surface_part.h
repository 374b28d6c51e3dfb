#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/load/agreement.h"
#include "data/load/field/surface_lookup.h"
#include "data/load/load_context.h"
#include "data/load/scene_facts.h"
#include "data/scene.h"

namespace aeolic {

/// The field at the moment shown, where it is sampled at every pixel.
struct ShownField {
    std::shared_ptr<const GridField> vectors, scalar;
};

/// "NAME: its steps are WHAT: between two the earlier one is shown".
std::string earlierIsShown(const std::string& name, const char* what);

/// One of a scene's surfaces: its own small scene, and its steps. A scene of one surface is that of its only part.
/// Whoever calls one part calls all, in the same order on every rank. Its first moment is in surface_part.cpp, all
/// others are in surface_moments.cpp, and what a field has on its points is in
/// SurfaceLookup.
class SurfacePart {
public:
    SurfacePart(LoadContext& context, std::size_t index);

    // The first moment, in this order.
    LoadedSurface readFirst(const ProgressReport& progress);           // Local. Unless it is a cut.
    void takeFirst(LoadedSurface&& surface, const PieceFacts& ofAll);  // Local. Unless it is a cut.
    void takeFirstField(const FieldStep& step);                        // Local. Where there is a field.
    void lookUp(const std::shared_ptr<const FieldStep>& step);         // Collective. Where there is a field.
    void unite();                                                      // Collective.

    /// Local. Whether vectors, or the scalar, are sampled at every pixel. Else the surface carries them.
    bool samplesVectors() const { return ask().fieldVectors && scene.field; }
    bool samplesScalar() const { return scalarOfField_ && scene.field; }
    /// Local. Needs the field in any way.
    bool usesField() const { return ask().fieldVectors || scalarOfField_; }
    bool isLookedUp() const { return lookup_.isCarried(); }

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
    void forgetMemory() { steps_.forget(); }                          // Local.

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
    void finishShape(LoadedSurface& surface) const;
    void takeSurface(LoadedSurface&& surface);
    void placePiece(LoadedSurface& piece, const PieceFacts& ofAll) const;
    void requireTriangles(std::vector<CutFacts> mine, std::uint64_t drawn);
    std::pair<const LoadedSurface*, const LoadedSurface*> stepsAround(const Moment& moment) const;
    LoadedSurface surfaceAt(const Moment& moment, bool interpolable);

    LoadContext& context_;
    const std::size_t index_;
    Agreement& agreement_ = context_.agreement;

    std::vector<Tally> tallies_;            // Of the surface's data that are shown.
    std::vector<std::string> ownWarnings_;  // The same, of its file alone.
    std::vector<std::string> told_;
    SceneRanges rangesAside_;  // Between beginWarnings() and endWarnings().
    std::vector<std::string> warningsAside_;
    CutFacts firstCut_;           // The first moment's isosurface.
    glm::dvec3 originWorld_{0};   // The first moment's, for all others.
    bool scalarOfField_ = false;  // What is coloured by is the field's, and the surface was not cut with it.
    std::string ownScalar_;       // Label of the array to colour by that the surface came with, or empty.
    bool warned_ = false;
    SurfaceLookup lookup_;
    Series<LoadedSurface> steps_;  // Last: its thread uses the others.
};

}  // namespace aeolic
