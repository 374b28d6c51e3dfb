#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aeolic {

/// A patch of a mesh's boundary: a run of its faces.
struct FoamPatch {
    std::string name, type;           ///< "inlet", "wall"
    std::vector<std::string> groups;  ///< Those the file names, and the type.
    std::uint64_t firstFace = 0, faces = 0;
};

/// An OpenFOAM case: one folder with a mesh, or several, processor0, processor1 …, each with a part of it.
struct FoamCase {
    std::string name;                  ///< As the user wrote it.
    std::vector<std::string> folders;  ///< Which hold constant/ and the times: the case's own, or each processor's.
    std::vector<double> times;  ///< Increasing; without 0, the state before the first step, where there are more.
    std::vector<std::string> regions;  ///< "" alone, or the names of several meshes.
    bool decomposed() const { return folders.size() > 1; }
};

/// Looks at the folders of the case alone. Where there are processors' folders as well as a mesh that was put together
/// again, whichever has the later time counts, at a tie the latter. `CASE/processor*` demands the former. Throws
/// InputError for a folder that is not a case, processors that are missing, or times that differ between processors.
FoamCase findFoamCase(const std::string& path);

/// The folder of a time's fields: `time` is one of the case's. Throws InputError where there is none.
std::string foamTimeFolder(const std::string& folder, double time);

/// The file of a mesh ("points", "faces", "boundary" …) at a time: that of the last time up to it that has one, else
/// that of constant/.
std::string foamMeshFile(const std::string& folder, const std::string& region, double time, const std::string& file);

/// The patches of one folder's mesh, those between processors included. Throws InputError for a damaged file.
std::vector<FoamPatch> readFoamBoundary(const std::string& path);

/// A field as its file's header tells it.
struct FoamField {
    std::string name;
    int components = 1;
    std::vector<double> times = {};  ///< Those at which it is there, where they were asked for.
};

/// The fields of cells and faces at a time, by name. Files that are something else, or damaged, are left out.
std::vector<FoamField> foamFields(const FoamCase& foam, const std::string& region, double time);

/// Those of all times, with their times.
std::vector<FoamField> foamFieldsOfAllTimes(const FoamCase& foam, const std::string& region);

/// Throws InputError where `array`, "U" or "U:mag", is of a field that is there at other times alone.
void requireFoamFieldAt(const FoamCase& foam, const std::string& region, double time, const std::string& array);

/// The first of the case's times with all of the arrays that are there at any time, by its number; 0 where none has.
std::size_t firstFoamStepWith(const FoamCase& foam, const std::vector<std::string>& arrays);

}  // namespace aeolic
