#include "data/load/load_context.h"

#include <utility>

namespace aeolic {

LoadContext::LoadContext(const SceneDescription& d, const Data& m, const Split& s, Agreement& a)
    : split(s),
      agreement(a),
      reader(d, m, s.field ? a.part() : FieldPart{}, s.surface ? a.part() : FieldPart{}),
      fields(sources.field, [this](double key, const ProgressReport& progress) {
          return std::make_shared<const FieldStep>(reader.field(key, progress));
      })
{
    reader.ranksOnHost = split.ranksOnHost;
    reader.readsForHost = agreement.isFirstOnHost();
    if (!split.field && !m.hasField()) reader.fieldReaders = agreement.part();
    if (!split.surface && !m.surface) reader.surfaceReaders = agreement.part();
}

void LoadContext::completeSteps(const Around& around)
{
    fields.complete(around, [&](FieldStep& step) { reader.complete(step, agreement); });
}

void LoadContext::keepStep(const std::shared_ptr<const FieldStep>& step)
{
    if (onlyStep) return;
    onlyStep = step;
    if (!reader.memory.volume || !step->cells) return;
    auto own = std::make_shared<FieldStep>(*step);
    own->cells = step->cells->copy();
    onlyStep = std::move(own);
}

}  // namespace aeolic
