#include <stdexcept>
#include <string>

#include "render/gl/device/programs.h"

/// What cmake/embed.cmake puts into the library.
struct EmbeddedShader {
    const char *name, *begin, *end;
};
extern "C" const EmbeddedShader aeolicShaders[];

namespace aeolic::gl {

std::string_view shaderSource(std::string_view file)
{
    for (const EmbeddedShader* shader = aeolicShaders; shader->name; ++shader)
        if (file == shader->name) return {shader->begin, std::size_t(shader->end - shader->begin)};
    throw std::logic_error("no shader is called " + std::string(file));
}

}  // namespace aeolic::gl
