#include "cluster/guards/guard_plan.h"

#include <algorithm>

namespace aeolic {

GuardPlan::GuardPlan(Stripes stripes, std::unique_ptr<GuardEstimate> reach, std::vector<RowFlow> facts)
    : stripes_(std::move(stripes)), reach_(std::move(reach)), facts_(std::move(facts))
{
}

Extent GuardPlan::withGuards(int rank, int steps) const
{
    return withGuard(stripes_.extent(rank, 1), rows(rank, steps), stripes_.height());
}

std::vector<Extent> GuardPlan::rowsOfAll(const std::optional<int>& steps) const
{
    std::vector<Extent> rows;
    rows.reserve(std::size_t(stripes_.ranks()));
    for (int r = 0; r < stripes_.ranks(); ++r) rows.push_back(steps ? withGuards(r, *steps) : stripes_.extent(r, 1));
    return rows;
}

GuardRows GuardPlan::sentRows(int rank, int steps) const
{
    const Extent own = stripes_.extent(rank, 1);
    const PartRows all{nullptr, rowsOfAll({}), rowsOfAll(steps)};
    GuardRows sent;
    for (int user = 0; user < stripes_.ranks(); ++user)
        for (const RowSpan& rows : shared(all, user, rank)) {
            const bool userAbove = stripes_.extent(user, 1).y1 <= own.y0;
            (userAbove ? sent.above : sent.below) =
                std::max(userAbove ? sent.above : sent.below, userAbove ? rows.y1 - own.y0 : own.y1 - rows.y0);
        }
    return sent;
}

std::vector<RowSpan> GuardPlan::shared(const PartRows& part, int user, int owner) const
{
    const Extent &mine = part.had[std::size_t(user)], &all = part.needed[std::size_t(user)],
                 owned = stripes_.extent(owner, 1);
    if (user == owner || mine.empty() || owned.empty()) return {};
    std::vector<RowSpan> shared;
    for (const RowSpan& side : {RowSpan{all.y0, mine.y0}, RowSpan{mine.y1, all.y1}}) {
        const RowSpan rows{std::max(side.y0, owned.y0), std::min(side.y1, owned.y1)};
        if (!rows.empty()) shared.push_back(rows);
    }
    return shared;
}

void GuardPlan::addReached(const JumpFootprint& all, int user, const RowSpan& owned, std::vector<Extent>& pixels)
{
    const RowSpan* reached = &all.rows[std::size_t(user) * std::size_t(all.columns)];
    RowSpan rows{owned.y1, owned.y0};
    for (int c = 0; c < all.columns; ++c) {
        rows.y0 = std::min(rows.y0, std::max(reached[c].y0, owned.y0));
        rows.y1 = std::max(rows.y1, std::min(reached[c].y1, owned.y1));
    }
    for (int y = rows.y0; y < rows.y1;) {
        // No span begins or ends before the next of these rows: memory is read along rows as far as can be.
        const int end = std::min((y / JumpFootprint::kRows + 1) * JumpFootprint::kRows, rows.y1);
        const auto has = [&](int c) { return reached[c].y0 <= y && y < reached[c].y1; };
        for (int c = 0; c < all.columns; ++c) {
            if (!has(c)) continue;
            const int first = c;
            while (c + 1 < all.columns && has(c + 1)) ++c;
            pixels.push_back({first * JumpBoxes::kColumns, y, (c + 1) * JumpBoxes::kColumns, end});
        }
        y = end;
    }
}

void GuardPlan::addRows(const RowSpan& owned, std::vector<Extent>& pixels) const
{
    for (int y = owned.y0; y < owned.y1; ++y) {
        const ColumnSpan flow = flowOf(y);
        if (!flow.empty()) pixels.push_back({flow.x0, y, flow.x1, y + 1});
    }
}

std::vector<RowLoad> GuardPlan::loads(const std::vector<PartRows>& parts, int user, int owner) const
{
    std::vector<RowLoad> loads;
    if (user == owner) return loads;
    for (const PartRows& part : parts) {
        RowLoad load{&part.part->images, {}};
        for (const RowSpan& rows : shared(part, user, owner))
            if (part.part->reached)
                addReached(*part.part->reached, user, rows, load.pixels);
            else
                addRows(rows, load.pixels);
        const int width = load.images->front().valid.x1;
        for (Extent& pixels : load.pixels) pixels.x1 = std::min(pixels.x1, width);
        if (!load.pixels.empty()) loads.push_back(std::move(load));
    }
    return loads;
}

}  // namespace aeolic
