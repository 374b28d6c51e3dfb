#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace aeolic {

/// The lines of an OBJ file, each with those that a backslash at its end joins to it.
class ObjLines {
public:
    explicit ObjLines(std::istream& file) : file_(file) {}

    /// Goes to the next one; false: there is none.
    bool next();

    const std::string& line() const { return line_; }
    std::int64_t number() const { return number_; }  ///< Of its last part.
    bool isTooLong() const;                          ///< VTK has no room for it, and it may go on.

private:
    std::istream& file_;
    std::string line_;
    std::int64_t number_ = 0;
};

/// VTK's reader looks up texture coordinates and normals wherever a face says, and puts lines into memory of a fixed
/// size. Throws InputError, which begins with `path`, unless all that faces, lines and points refer to is there. False:
/// VTK would leave out faces without normals, or refuse the file, unless texture coordinates and normals are left out.
bool checkObj(std::istream& file, const std::string& path);

}  // namespace aeolic
