#include "render/gl/device/programs.h"

#include <fmt/ranges.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "base/embedded_file.h"
#include "render/antialias.h"
#include "render/flatten.h"
#include "render/front_bias.h"
#include "render/gbuffer.h"
#include "render/gl/device/device_errors.h"
#include "render/gl/device/gl_blocks.h"
#include "render/lic/along_flow.h"
#include "render/lic/jump_plan.h"
#include "render/lic/lic_kernel.h"
#include "render/lic/noise.h"
#include "render/lic/phase_mix.h"
#include "render/limits.h"
#include "render/occlusion.h"
#include "render/palette.h"
#include "render/shading_model.h"
#include "render/surface_mark.h"

extern "C" const aeolic::EmbeddedFile aeolicShaders[];

namespace aeolic::gl {
namespace {

/// A constant that shaders share with kernels and cluster code, under the same name.
template <class T>
std::string constant(const char* name, T value)
{
    char text[96];
    if constexpr (std::is_same_v<T, std::uint32_t>)
        std::snprintf(text, sizeof text, "const uint %s = %uu;\n", name, unsigned(value));
    else if constexpr (std::is_integral_v<T>)
        std::snprintf(text, sizeof text, "const int %s = %d;\n", name, int(value));
    else
        std::snprintf(text, sizeof text, "const float %s = float(%.9g);\n", name, double(value));
    return text;
}

template <std::size_t kCount>
std::string constants(const char* name, const std::array<float, kCount>& values)
{
    return fmt::format("const float {}[{}] = float[](float({:.9g}));\n", name, kCount, fmt::join(values, "), float("));
}

const std::string& constants()
{
    static const std::string text = [] {
        std::string lines;
        const auto add = [&](const char* name, auto value) { lines += constant(name, value); };
        add("kOpenReachPx", limits::kOpenReachPx);
        add("kOpenRings", limits::kOpenRings);
        add("kTogetherPx", limits::kTogetherPx);
        add("kSettledPx", limits::kSettledPx);
        add("kAlongRows", limits::kAlongRows);
        for (int k = 0; k <= limits::kAlongRows; ++k)
            add(("kAlongWeight" + std::to_string(k)).c_str(), along_flow::kWeights[k]);
        add("kFlatPerUnit", flatten::kPerUnit);
        add("kFlatZero", flatten::kZero);
        add("kFlatGain", flatten::kGain);
        add("kVanishing", limits::kVanishing);
        add("kLeastWeight", limits::kLeastWeight);
        add("kSteadyWidth", limits::kSteadyWidth);
        add("kLeastNoise", limits::kLeastNoise);
        add("kMostNoise", limits::kMostNoise);
        add("kAllNine", std::uint32_t(limits::kAllNine));
        add("kSlackSlope", limits::kSlackSlope);
        add("kDisplacementMax", flow_texel::kDisplacementMax);
        add("kNoiseZero", flow_texel::kNoiseZero);
        add("kNoiseMost", flow_texel::kNoiseMost);
        add("kDxShift", flow_texel::kDxShift);
        add("kDyShift", flow_texel::kDyShift);
        add("kHalfMost", jump_word::kHalfMost);
        add("kOpenBit", jump_word::kOpenBit);
        add("kAliveBit", jump_word::kAliveBit);
        add("kLengthShift", jump_word::kLengthShift);
        add("kLengthMost", jump_word::kLengthMost);
        add("kSumShift", jump_word::kSumShift);
        add("kSumMost", jump_word::kSumMost);
        add("kWidthShift", jump_word::kWidthShift);
        add("kWidthOne", jump_word::kWidthOne);
        add("kJumpLevels", JumpBlock::kLevels);
        add("kShortestOwnPx", kShortestOwnPx);
        add("kMostPhaseGain", kMostPhaseGain);
        add("kNearTile", kNearTile);
        add("kRowOfTiles", std::uint32_t(kRowOfTiles));
        add("kNoiseSize", int(NoisePyramid::kSize));
        add("kGrainShare", grains::kShare);
        add("kGrainBlendFrom", grains::kBlendFrom);
        add("kGrainBlendTo", grains::kBlendTo);
        add("kGrainHeight", grains::kHeight);
        add("kGrainHashFirst", grains::kHashFirst);
        add("kGrainHashSecond", grains::kHashSecond);
        lines += constants("kGrainWave", grains::kWave);
        lines += constants("kCometCosine", phase_mix::Comet::kCosine);
        lines += constants("kCometSine", phase_mix::Comet::kSine);
        add("kCometMean", phase_mix::Comet::kMean);
        add("kCometContrast", phase_mix::Comet::kContrast);
        add("kCometTakenOff", phase_mix::Comet::kTakenOff);
        add("kNoiseOffsetX", float(kNoiseLevelOffset[0]));
        add("kNoiseOffsetY", float(kNoiseLevelOffset[1]));
        add("kNoiseOffsetZ", float(kNoiseLevelOffset[2]));
        add("kAmbient", shading::kAmbient);
        add("kDiffuse", shading::kDiffuse);
        add("kSoft", shading::kSoft);
        add("kSoftRight", shading::kSoftRight);
        add("kSoftUp", shading::kSoftUp);
        add("kSoftForward", shading::kSoftForward);
        add("kSoftTurn", shading::kSoftTurn);
        add("kKneeZero", shading::kKneeZero);
        add("kSamples", antialias::kSamples);
        add("kParts", antialias::kParts);
        add("kReach", antialias::kReach);
        add("kMostFrontBias", float(kMostFrontBias));
        add("kFrontRounding", float(kFrontRounding));
        add("kLightStep", antialias::kLightStep);
        add("kUneven", antialias::kUneven);
        add("kDistanceShare", antialias::kDistanceShare);
        add("kFits", antialias::kFits);
        add("kTile", occlusion::kTile);
        add("kPatterns", occlusion::kPatterns);
        add("kTaps", occlusion::kTaps);
        add("kBefore", occlusion::kBefore);
        add("kSlackPx", occlusion::kSlackPx);
        add("kOcclusionStrength", occlusion::kStrength);
        add("kMaskedEntry", std::uint32_t(ScalarColors::kMasked));
        add("kBelowEntry", std::uint32_t(ScalarColors::kBelow));
        add("kAboveEntry", std::uint32_t(ScalarColors::kAbove));
        add("kAllEntries", std::uint32_t(ScalarColors::kAll));
        add("kColorEntries", std::uint32_t(ScalarColors::kEntries));
        add("kPlainKind", std::uint32_t(surface_mark::kPlain));
        add("kMostKinds", std::uint32_t(surface_mark::kMostKinds));
        add("kOwnVectors", std::uint32_t(surface_mark::kOwnVectors));
        add("kOwnScalar", std::uint32_t(surface_mark::kOwnScalar));
        add("kNoStreaks", std::uint32_t(surface_mark::kNoStreaks));
        for (int i = 0; i < 4; ++i) add(("kErf" + std::to_string(i)).c_str(), shading::kErf[i]);
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

struct ShaderSource {
    GLenum kind;
    const char* extension;
};

Program build(const std::string& name, const std::vector<ShaderSource>& stages, const std::vector<Define>& defines)
{
    Program program(glCreateProgram());
    for (const ShaderSource& stage : stages) {
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

std::string_view shaderSource(std::string_view file)
{
    for (const EmbeddedFile* shader = aeolicShaders; shader->name; ++shader) {
        const std::string_view path = shader->name;
        if (path.substr(path.rfind('/') + 1) == file) return {shader->begin, std::size_t(shader->end - shader->begin)};
    }
    throw std::logic_error("no shader is called " + std::string(file));
}

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
