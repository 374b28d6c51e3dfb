#include "render/gl/device/beside_rows.h"

#include <algorithm>

namespace aeolic::gl {
namespace {

constexpr int kWordBytes = 4;

}  // namespace

std::size_t BesideRows::placeOf(int y) const
{
    return std::size_t(y - held_.y0) * std::size_t(held_.width()) * kWordBytes;
}

void BesideRows::hold(const Extent& compute, int rows, int height)
{
    compute_ = compute;
    rows_ = rows;
    held_ = withGuard(compute, {rows, rows}, height);
    words_.reserve(placeOf(held_.y1) + kWordBytes);
}

void BesideRows::receive(RowExchange& beside)
{
    travelling_.reserve(placeOf(held_.y1) + kWordBytes);
    const auto copy = [&](GLuint from, GLuint to, int y0, int y1) {
        if (y0 >= y1) return;
        glCopyNamedBufferSubData(from, to, GLintptr(placeOf(y0)), GLintptr(placeOf(y0)),
                                 GLsizeiptr(placeOf(y1) - placeOf(y0)));
    };
    const GLuint words = words_.get().id();
    const int upperEnd = std::min(compute_.y0 + rows_, compute_.y1);
    copy(words, travelling_.id(), compute_.y0, upperEnd);
    copy(words, travelling_.id(), std::max(compute_.y1 - rows_, upperEnd), compute_.y1);
    copied_.set();
    copied_.wait();
    beside.receive({travelling_.data(), std::ptrdiff_t(held_.width()) * kWordBytes, kWordBytes, held_}, rows_);
    copy(travelling_.id(), words, held_.y0, compute_.y0);
    copy(travelling_.id(), words, compute_.y1, held_.y1);
}

}  // namespace aeolic::gl
