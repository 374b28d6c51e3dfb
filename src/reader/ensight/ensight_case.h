#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aeolic {

/// A file of an EnSight case, or several, with '*' in its name for the number of a step or of a file.
struct EnSightFile {
    std::string pattern;
    int timeSet = 0;  ///< 0: none is named.
    int fileSet = 0;  ///< That of files which hold several steps each; 0: a step has a file of its own.
};

/// Files that hold several steps each, one after the other.
struct EnSightFileSet {
    struct Steps {
        std::string index;  ///< What stands in the place of '*'; empty: there is one file.
        std::size_t count = 0;
    };
    int number = 0;  ///< As the case file calls it.
    std::vector<Steps> files;
};

/// Where a file or a step of it stands.
struct EnSightPlace {
    std::string path;
    std::optional<std::size_t> step;  ///< Of those in the file, from 0; nothing: it is all one.
};

struct EnSightVariable {
    std::string name;
    bool onPoints = true;
    int components = 1;  ///< 1 or 3.
    EnSightFile file;
};

struct EnSightTimes {
    int number = 0;                    ///< As the case file calls it.
    std::vector<double> values;        ///< Increasing; at least one.
    std::vector<std::string> numbers;  ///< Of the files, one for each value.
};

/// What the text of an EnSight Gold case file says.
struct EnSightCase {
    std::string path, folder;
    EnSightFile geometry;
    std::vector<EnSightVariable> variables;  ///< Scalars and vectors on nodes or elements. Others are left out.
    std::vector<EnSightTimes> timeSets;
    std::vector<EnSightFileSet> fileSets;
    bool isForVtk = false;  ///< It is of EnSight 6.

    /// The times of all sets that files use, increasing, each once. Empty where nothing changes.
    std::vector<double> times() const;

    const EnSightFileSet* fileSet(int number) const;  ///< Null where there is none.

    /// What holds at a time: that of the latest step which is not later, else of the first step. No time: the first of
    /// times().
    EnSightPlace placeAt(const EnSightFile& file, std::optional<double> time) const;
};

/// The words of a line. Quotes hold blanks together.
std::vector<std::string> ensightWords(const std::string& text);

/// Reads a case file, and looks whether every file that it names for every step is there. Throws InputError, which
/// begins with `path`. Of a case for VTK nothing else counts than `isForVtk`, and VTK looks for its files.
EnSightCase readEnSightCase(const std::string& path);

}  // namespace aeolic
