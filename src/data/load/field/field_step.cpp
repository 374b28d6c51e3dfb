#include "data/load/field/field_step.h"

#include <utility>

#include "aeolic/error.h"
#include "base/byte_message.h"
#include "data/load/surface_message.h"

namespace aeolic {

/// A grid without its samples.
template <PerhapsConst<GridField> Field, class Visit>
void withMembers(Field& field, const Visit& visit)
{
    visit(field.dims, field.originWorld, field.spacingWorld, field.components, field.precision, field.tiled,
          field.maxMagnitude, field.name);
}

namespace {

std::optional<GridField> gridOf(const std::shared_ptr<const GridField>& field)
{
    return field ? std::optional(*field) : std::nullopt;
}

/// Whether samples of the one can be taken for those of the other.
bool isLaidOutLike(const GridField& a, const GridField& b)
{
    return a.dims == b.dims && a.components == b.components && a.precision == b.precision && a.tiled == b.tiled;
}

/// `mine`: what this rank has read, or null; `field`: what the first rank has read, without samples. `file`: its name.
std::shared_ptr<const GridField> shareGrid(const std::shared_ptr<const GridField>& mine, std::optional<GridField> field,
                                           const std::string& file, Agreement& agreement)
{
    if (!field) return nullptr;
    const bool gives = agreement.isFirstOnHost();
    agreement.together([&] {
        if (gives && !(mine && isLaidOutLike(*mine, *field)))
            throw InputError(file, "it holds another grid than on the first host", "the same file on every host");
    });
    field->samples = agreement.shareOnHost(gives ? mine->samples : nullptr, gives ? mine->bytes() : 0);
    return std::make_shared<const GridField>(std::move(*field));
}

}  // namespace

void shareStep(FieldStep& step, Agreement& agreement)
{
    Bytes message;
    agreement.together([&] {
        if (agreement.part().rank > 0) return;
        ByteWriter writer;
        writer.addAll(static_cast<const FieldFacts&>(step), gridOf(step.vectors), gridOf(step.scalar),
                      step.readCells != nullptr, std::uint64_t(step.cuts.size()));
        for (const auto& cut : step.cuts) writer.add(cut ? messageOf(*cut) : Bytes{});
        message = writer.take();
    });
    message = agreement.ofFirst(std::move(message));
    FieldStep all;
    std::optional<GridField> vectors, scalar;
    bool hasCells = false;
    agreement.together([&] {
        ByteReader reader(message);
        std::uint64_t cuts = 0;
        reader.readAll(static_cast<FieldFacts&>(all), vectors, scalar, hasCells, cuts);
        all.cuts.resize(cuts);
        for (auto& cut : all.cuts) {
            std::span<const std::byte> surface;
            reader.read(surface);
            if (!surface.empty()) cut = surfaceOf(surface);
        }
    });
    message = {};
    all.vectors = shareGrid(step.vectors, std::move(vectors), all.name, agreement);
    all.scalar = shareGrid(step.scalar, std::move(scalar), all.name, agreement);
    if (hasCells) {
        std::vector<std::shared_ptr<const CellVolume>> own;
        if (agreement.part().rank == 0) own.push_back(step.readCells);
        all.cells = dealtVolume(std::move(own), false, all.name, agreement);
    }
    step = std::move(all);
}

std::uint64_t FieldStep::countCells() const
{
    if (cells) return cells->cells;
    return vectors ? std::uint64_t(vectors->dims[0]) * std::uint64_t(vectors->dims[1]) * std::uint64_t(vectors->dims[2])
                   : 0;
}

}  // namespace aeolic
