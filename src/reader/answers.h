#pragma once

#include "base/byte_message.h"
#include "data/progress.h"
#include "data/reading/questions.h"

namespace aeolic {

/// Looks at a file for a Question, and adds what it asks for to the message. Throws InputError.
void addAnswer(ByteWriter& message, const LookRequest& request, const ProgressReport& progress);

}  // namespace aeolic
