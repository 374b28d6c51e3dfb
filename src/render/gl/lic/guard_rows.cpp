#include "render/gl/lic/guard_rows.h"

#include <algorithm>

namespace aeolic::gl {
void GuardRowExchange::begin(GuardExchange& guards, const Extent& compute, const Extent& valid, StageTimers& timers)
{
    guards_ = &guards;
    timers_ = &timers;
    compute_ = compute;
    valid_ = valid;
    transfers_.clear();
    bytes_ = 0;
}

std::size_t GuardRowExchange::planeBytes(const Transfer& transfer) const
{
    const std::size_t pixels = std::size_t(valid_.width()) * std::size_t(std::max(valid_.height(), 0));
    return (pixels * std::size_t(texelFormat(transfer.planes[0].texture->format()).bytes) + 15) / 16 * 16;
}

void GuardRowExchange::add(const std::vector<Plane>& planes, int reach)
{
    transfers_.push_back({planes, reach, bytes_});
    bytes_ += planes.size() * planeBytes(transfers_.back());
}

GuardRows GuardRowExchange::sent() const
{
    GuardRows most;
    for (const Transfer& transfer : transfers_) {
        const GuardRows rows = guards_->sentRows(transfer.reach);
        most = {std::max(most.above, rows.above), std::max(most.below, rows.below)};
    }
    return most;
}

ImageRows GuardRowExchange::rowsOf(const Transfer& transfer, std::size_t plane) const
{
    const int bytes = texelFormat(transfer.planes[plane].texture->format()).bytes;
    return {memory_.data() + transfer.offset + plane * planeBytes(transfer), std::ptrdiff_t(valid_.width()) * bytes,
            bytes, valid_};
}

template <class Move>
void GuardRowExchange::forEachPlane(const Transfer& transfer, int y0, int y1, const Move& move) const
{
    y0 = std::max(y0, valid_.y0);
    y1 = std::min(y1, valid_.y1);
    if (y0 >= y1) return;
    for (std::size_t i = 0; i < transfer.planes.size(); ++i) {
        const ImageRows rows = rowsOf(transfer, i);
        move(transfer.planes[i], y0 - valid_.y0, y1 - valid_.y0,
             offsetPointer(std::size_t(rows.at(valid_.x0, y0) - memory_.data())));
    }
}

void GuardRowExchange::send()
{
    memory_.reserve(bytes_ + 16);
    const PixelsInto memory(memory_);
    const auto take = [&](const Plane& plane, int y0, int y1, void* to) {
        plane.texture->readRows(y0, y1, plane.layer, to);
    };
    for (const Transfer& transfer : transfers_) {
        const GuardRows sent = guards_->sentRows(transfer.reach);
        const int upperEnd = std::min(compute_.y0 + sent.above, compute_.y1);
        forEachPlane(transfer, compute_.y0, upperEnd, take);
        forEachPlane(transfer, std::max(compute_.y1 - sent.below, upperEnd), compute_.y1, take);
    }
    copied_.set();
}

void GuardRowExchange::receive()
{
    timers_->end();
    copied_.wait();
    std::vector<GuardPart> parts;
    for (const Transfer& transfer : transfers_) {
        parts.push_back({{}, transfer.reach});
        for (std::size_t i = 0; i < transfer.planes.size(); ++i) parts.back().images.push_back(rowsOf(transfer, i));
    }
    guards_->receive(parts);
    timers_->begin(Stage::convolve);
    const PixelsFrom memory(memory_);
    const auto put = [&](const Plane& plane, int y0, int y1, const void* from) {
        plane.texture->writeRows(y0, y1, plane.layer, from);
    };
    for (const Transfer& transfer : transfers_) {
        const GuardRows needed = guards_->rows(transfer.reach);
        forEachPlane(transfer, compute_.y0 - needed.above, compute_.y0, put);
        forEachPlane(transfer, compute_.y1, compute_.y1 + needed.below, put);
    }
    transfers_.clear();
    bytes_ = 0;
}

}  // namespace aeolic::gl
