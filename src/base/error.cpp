#include "aeolic/error.h"

#include "base/text.h"

namespace aeolic {

InputError::InputError(const std::string& message) : std::runtime_error(withoutControls(message)) {}

}  // namespace aeolic
