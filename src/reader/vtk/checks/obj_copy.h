#pragma once

#include <istream>
#include <memory>
#include <string>

namespace aeolic {

/// An OBJ file without its texture coordinates and normals, in memory: VTK leaves out faces without normals where
/// others have them.
class ObjCopy {
public:
    /// Throws InputError, which begins with `path`, where there is no memory for it.
    ObjCopy(std::istream& file, const std::string& path);
    ~ObjCopy();
    ObjCopy(const ObjCopy&) = delete;
    ObjCopy& operator=(const ObjCopy&) = delete;

    /// By this name it can be opened as long as this lives.
    std::string name() const;

private:
    int descriptor_;
};

/// Checks an OBJ file as checkObj() does. Null where VTK can read it as it is.
std::unique_ptr<ObjCopy> checkedObj(const std::string& path);

}  // namespace aeolic
