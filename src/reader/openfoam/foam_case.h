#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "reader/openfoam/foam_stream.h"

namespace aeolic {

/// A patch of a mesh's boundary: a run of its faces.
struct FoamPatch {
    std::string name, type;           ///< "inlet", "wall"
    std::vector<std::string> groups;  ///< Those the file names, and the type.
    std::uint64_t firstFace = 0, faces = 0;
};

/// An OpenFOAM case: one folder with a mesh, or several, processor0, processor1 …, each with a part of it. In the
/// collated format these are blocks of the files in processors4, or in processors4_0-1, processors4_2-3 …
struct FoamCase {
    std::string name;               ///< As the user wrote it.
    std::vector<FoamPath> folders;  ///< Which hold constant/ and the times: the case's own, or each processor's.
    std::vector<double> times;      ///< Increasing; without 0, the state before the first step, where there are more.
    std::vector<std::string> regions;  ///< "" alone, or the names of several meshes.

    bool decomposed() const { return folders.size() > 1; }

    /// The moment that is read where none is given: the first. 0 where the case has no times.
    double firstTime() const { return times.empty() ? 0 : times.front(); }
};

/// What is in a folder, sorted. Nothing where it cannot be looked into.
std::vector<std::string> namesInFolder(const std::filesystem::path& folder);

/// Looks at the folders of the case alone. Where there are processors' folders as well as a mesh that was put together
/// again, whichever has the later time counts, at a tie the latter. `CASE/processor*` demands the former. Throws
/// InputError for a folder that is not a case, processors that are missing, or times that differ between processors.
FoamCase findFoamCase(const std::string& path);

/// The file of a time's field. `time` is one of the case's. Throws InputError where there is none.
FoamPath foamFieldFile(const FoamPath& folder, const std::string& region, double time, const std::string& field);

/// The file of a mesh ("points", "faces", "boundary" …) at a time: that of the last time up to it that has one, else
/// that of constant/.
FoamPath foamMeshFile(const FoamPath& folder, const std::string& region, double time, const std::string& file);

/// The patches of one folder's mesh, those between processors included. Throws InputError for a damaged file.
std::vector<FoamPatch> readFoamBoundary(const FoamPath& file);

/// A field as its file's header tells it.
struct FoamField {
    std::string name;
    int components = 1;
    std::vector<double> times = {};  ///< Those at which any region has it, of those that were asked for.
};

/// The fields of cells and faces that any region has at any of these times of the case, with those of these times that
/// have them. Files that are something else, or damaged, are left out.
std::vector<FoamField> foamFields(const FoamCase& foam, const std::vector<double>& times);

/// The vectors that are drawn where none are named: wallShearStress on walls, else U, else the only ones. Empty where
/// there are several others, or none.
std::string usualFoamVectors(const std::vector<FoamField>& fields, bool walls);

/// Whether any folder has the field for this region.
bool foamHasField(const FoamCase& foam, const std::string& region, double time, const FoamField& field);

/// Throws InputError where `array`, "U" or "U:mag", is of a field that is there at other times alone, or whose header
/// is damaged at this time.
void requireFoamFieldAt(const FoamCase& foam, double time, const std::string& array);

}  // namespace aeolic
