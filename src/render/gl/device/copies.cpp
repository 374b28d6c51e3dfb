#include "render/gl/device/copies.h"

#include <array>
#include <cstring>

#include "render/gl/device/dispatch.h"

namespace aeolic::gl {
namespace {

// Texels of rows [y0, y0 + rows) of those held, without padding.
template <class T>
std::vector<T> texels(const Texture& texture, int y0, int rows)
{
    std::vector<T> values(std::size_t(texture.width()) * std::size_t(std::max(rows, 0)));
    if (values.empty()) return values;
    texture.readRows(y0, y0 + rows, 0, values.data());
    return values;
}

// Calls put(x, y, value) for every texel of the rows held.
template <class T, class Put>
void forEachTexel(const Texture& texture, const Extent& valid, const Put& put)
{
    const std::vector<T> values = texels<T>(texture, 0, valid.height());
    std::size_t at = 0;
    for (int y = valid.y0; y < valid.y1; ++y)
        for (int x = valid.x0; x < valid.x1; ++x) put(x, y, values[at++]);
}

}  // namespace

void copyGBuffer(const FrameImages& images, bool withScalar, GBuffer& out)
{
    const Extent& valid = images.valid;
    out.resize(valid, withScalar);
    const std::vector<std::uint32_t> seen = texels<std::uint32_t>(images.visible, valid.y0, valid.height());
    const auto covered = [&](int x, int y) {
        return seen[std::size_t(y - valid.y0) * std::size_t(valid.width()) + std::size_t(x)] != 0;
    };
    forEachTexel<std::array<float, 4>>(images.surface, valid, [&](int x, int y, const std::array<float, 4>& v) {
        const bool there = covered(x, y);
        out.invDepth.at(x, y) = there ? v[0] : 0;
        out.gradX.at(x, y) = there ? v[1] : 0;
        out.gradY.at(x, y) = there ? v[2] : 0;
        out.light.at(x, y) = there ? v[3] : 0;
    });
    forEachTexel<std::uint32_t>(images.flow, valid, [&](int x, int y, std::uint32_t v) { out.flow.at(x, y) = v; });
    forEachTexel<std::uint8_t>(images.links, valid, [&](int x, int y, std::uint8_t v) {
        out.links.at(x, y) = out.flow.at(x, y) ? v : 0;  // Elsewhere they are not kept.
    });
    if (withScalar)
        forEachTexel<float>(images.scalar, valid,
                            [&](int x, int y, float v) { out.scalar.at(x, y) = covered(x, y) ? v : 0; });
}

void copySeen(const FrameImages& images, const Extent& rows, SeenSurface& out)
{
    out.resize(rows);
    const int first = rows.y0 - images.valid.y0;
    const std::vector<std::uint32_t> visible = texels<std::uint32_t>(images.visible, rows.y0, rows.height()),
                                     flow = texels<std::uint32_t>(images.flow, first, rows.height());
    const auto surface = texels<std::array<float, 4>>(images.surface, first, rows.height());
    std::size_t at = 0;
    for (int y = rows.y0; y < rows.y1; ++y)
        for (int x = rows.x0; x < rows.x1; ++x, ++at) {
            const bool there = visible[at] != 0;
            out.invDepth.at(x, y) = there ? surface[at][0] : 0;
            out.gradX.at(x, y) = there ? surface[at][1] : 0;
            out.gradY.at(x, y) = there ? surface[at][2] : 0;
            out.flow.at(x, y) = there ? flow[at] : 0;
        }
}

void copyFlow(const FrameImages& images, Image<std::uint32_t>& flow, Image<float>* scalar)
{
    const Extent& valid = images.valid;
    forEachTexel<std::uint32_t>(images.flow, valid, [&](int x, int y, std::uint32_t v) { flow.at(x, y) = v; });
    if (scalar) forEachTexel<float>(images.scalar, valid, [&](int x, int y, float v) { scalar->at(x, y) = v; });
}

void copyLic(const FrameImages& images, bool hasLic, const Extent& compute, Image<float>& out)
{
    out.resize(compute);
    const int y0 = compute.y0 - images.valid.y0;
    const std::vector<float> values = texels<float>(images.lic, y0, compute.height());
    const std::vector<std::uint32_t> flow = texels<std::uint32_t>(images.flow, y0, compute.height());
    std::size_t at = 0;
    for (int y = compute.y0; y < compute.y1; ++y)
        for (int x = compute.x0; x < compute.x1; ++x, ++at) out.at(x, y) = hasLic && flow[at] != 0 ? values[at] : 0.0f;
}

void upload(const Texture& texture, ImageRows rows, int y0, int y1)
{
    if (y0 >= y1) return;
    glPixelStorei(GL_UNPACK_ROW_LENGTH, GLint(rows.strideBytes / rows.pixelBytes));
    texture.writeRows(y0 - rows.valid.y0, y1 - rows.valid.y0, 0, rows.at(rows.valid.x0, y0));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void setLic(const FrameImages& images, const Image<float>& values)
{
    const Extent& extent = values.valid();
    std::vector<float> packed;
    for (int y = extent.y0; y < extent.y1; ++y)
        packed.insert(packed.end(), values.row(y) + extent.x0, values.row(y) + extent.x1);
    images.lic.writeRows(extent.y0 - images.valid.y0, extent.y1 - images.valid.y0, 0, packed.data());
}

std::vector<RowFlow> RowFlowCopy::get(Programs& programs, const FrameImages& images, int y0, int y1)
{
    const int rows = std::max(y1 - y0, 0);
    std::vector<RowFlow> facts(static_cast<std::size_t>(rows));
    if (rows == 0) return facts;
    using Words = std::array<std::uint32_t, 4>;
    facts_.reserve(facts.size() * sizeof(Words));
    const GLuint program = programs.compute("row_flow");
    setInts(program, 0, y0 - images.valid.y0, rows, images.valid.width());
    images.flow.bind(0);
    bindStorage(0, facts_.get());
    dispatch(program, GLuint(rows));
    copy_.copy(facts_.get(), facts.size() * sizeof(Words));
    copy_.start();
    const std::byte* found = copy_.wait();
    for (RowFlow& row : facts) {
        Words words;
        std::memcpy(&words, found, sizeof words);
        found += sizeof words;
        row = {std::uint16_t(words[0]), std::uint16_t(words[1]), std::uint16_t(words[2])};
    }
    return facts;
}

}  // namespace aeolic::gl
