#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/device/objects.h"

namespace aeolic::gl {

/// A name and value of the shader language's preprocessor.
struct Define {
    const char* name;
    int value;
};

/// The text of a file of src/render/gl/shaders, embedded in the library. Throws std::logic_error for another name.
std::string_view shaderSource(std::string_view file);

/// Programs of one context, compiled when first asked for.
class Programs {
public:
    /// The compute program of `file` (without .comp) with these defines.
    GLuint compute(const char* file, const std::vector<Define>& defines = {});
    /// The drawing program of `file`.vert and `file`.frag.
    GLuint drawing(const char* file);
    void clear() { programs_.clear(); }

private:
    std::map<std::string, Program> programs_;
};

}  // namespace aeolic::gl
