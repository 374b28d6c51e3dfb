#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/extent.h"
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

/// Sets a uniform `ivec4` of x0, y0, x1, y1.
void setExtent(GLuint program, GLint location, const Extent& area);

/// Runs a program over `area`, which it gets as the uniform at location 0. Its groups are `groupWidth` x 8 pixels.
void dispatchOver(GLuint program, const Extent& area, int groupWidth = 16);

}  // namespace aeolic::gl
