#include "render/gl/device/programs.h"

#include <cstdio>

#include "render/gbuffer.h"
#include "render/gl/device/device_errors.h"
#include "render/lic_kernel.h"
#include "render/noise.h"
#include "render/shading_model.h"

namespace aeolic::gl {
namespace {

std::string number(double value)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.9g", value);
    const bool whole = std::string_view(text).find_first_of(".e") == std::string_view::npos;
    return std::string(text) + (whole ? ".0" : "");
}

/// The constants that shaders share with the other backends.
const std::string& constants()
{
    static const std::string text = [] {
        std::string lines;
        const auto add = [&](const char* name, const std::string& value) {
            lines += std::string("#define ") + name + " " + value + "\n";
        };
        add("NOISE_SIZE", std::to_string(NoisePyramid::kSize));
        add("NOISE_OFFSET_X", number(float(kNoiseLevelOffset[0])));
        add("NOISE_OFFSET_Y", number(float(kNoiseLevelOffset[1])));
        add("NOISE_OFFSET_Z", number(float(kNoiseLevelOffset[2])));
        add("SHADING_AMBIENT", number(shading::kAmbient));
        add("SHADING_DIFFUSE", number(shading::kDiffuse));
        add("COLOR_SHADOW", number(shading::kColorShadow));
        add("COLOR_HIGHLIGHT", number(shading::kColorHighlight));
        constexpr auto gray = unsigned(shading::kMaskedBase * 255);
        add("MASKED_GRAY", std::to_string(gray | gray << 8 | gray << 16) + "u");
        for (int i = 0; i < 4; ++i) add(("ERF_" + std::to_string(i)).c_str(), number(shading::kErf[i]));
        add("SHEETS_SLACK_SLOPE", number(sheets::kSlackSlope));
        add("SHORTEST_OWN_PX", number(kShortestOwnPx));
        return lines;
    }();
    return text;
}

/// The file with what it includes; each once.
void append(std::string_view file, std::vector<std::string>& included, std::string& out)
{
    for (const std::string& name : included)
        if (name == file) return;
    included.emplace_back(file);
    std::string_view left = shaderSource(file);
    while (!left.empty()) {
        const std::size_t end = std::min(left.find('\n'), left.size());
        const std::string_view line = left.substr(0, end);
        left.remove_prefix(std::min(end + 1, left.size()));
        constexpr std::string_view include = "#include \"";
        if (line.substr(0, include.size()) == include)
            append(line.substr(include.size(), line.rfind('"') - include.size()), included, out);
        else
            (out += line) += '\n';
    }
}

std::string sourceOf(const std::string& file, const std::vector<Define>& defines)
{
    std::string source = "#version 450 core\n" + constants();
    for (const Define& define : defines)
        source += std::string("#define ") + define.name + " " + std::to_string(define.value) + "\n";
    std::vector<std::string> included;
    append(file, included, source);
    return source;
}

// Throws what the driver has to say of a shader or program that it did not build.
template <class GetInteger, class GetLog>
void requireBuilt(GLuint id, GLenum status, const std::string& what, const GetInteger& get, const GetLog& getLog)
{
    GLint built = 0;
    get(id, status, &built);
    if (built) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    getLog(id, GLsizei(log.size()), &length, log.data());
    log.resize(std::size_t(length));
    deviceFailed("its driver does not accept " + what + ": " + log.substr(0, log.find('\n')));
}

struct Stage {
    GLenum kind;
    const char* extension;
};

Program build(const std::string& name, const std::vector<Stage>& stages, const std::vector<Define>& defines)
{
    Program program(glCreateProgram());
    for (const Stage& stage : stages) {
        const std::string file = name + stage.extension, source = sourceOf(file, defines);
        const char* text = source.c_str();
        const GLuint shader = glCreateShader(stage.kind);
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);  // The program keeps it as long as it is attached.
        requireBuilt(shader, GL_COMPILE_STATUS, file, glGetShaderiv, glGetShaderInfoLog);
    }
    glLinkProgram(program);
    requireBuilt(program, GL_LINK_STATUS, name, glGetProgramiv, glGetProgramInfoLog);
    return program;
}

}  // namespace

GLuint Programs::compute(const char* file, const std::vector<Define>& defines)
{
    std::string key = file;
    for (const Define& define : defines) key += " " + std::to_string(define.value);
    Program& program = programs_[key];
    if (!program) program = build(file, {{GL_COMPUTE_SHADER, ".comp"}}, defines);
    return program;
}

GLuint Programs::drawing(const char* file)
{
    Program& program = programs_[file];
    if (!program) program = build(file, {{GL_VERTEX_SHADER, ".vert"}, {GL_FRAGMENT_SHADER, ".frag"}}, {});
    return program;
}

}  // namespace aeolic::gl
