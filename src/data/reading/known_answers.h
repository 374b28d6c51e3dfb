#pragma once

#include <map>
#include <string>

#include "base/byte_message.h"

namespace aeolic {

/// What readers have answered this thread (file_questions.h), as long as the object lives. This thread does not
/// ask the same again, unless it was refused. The ranks of a host exchange it, so that one of them asks for all. Scopes
/// may lie within each other; the innermost one counts.
class KnownAnswers {
public:
    KnownAnswers();
    KnownAnswers(const KnownAnswers&) = delete;
    KnownAnswers& operator=(const KnownAnswers&) = delete;
    ~KnownAnswers();

    /// All that is known, as a message for another rank of this host.
    Bytes message() const;
    /// Knows what another rank's message() tells, too. Throws std::runtime_error where it is cut off.
    void take(ByteReader& message);

    /// This thread's, or null.
    static KnownAnswers* current();
    /// An answer's text; null where it is not known. `request`: as it is sent to a reader.
    const Bytes* find(const Bytes& request) const;
    void keep(const Bytes& request, const Bytes& answer);

private:
    KnownAnswers* outer_;
    std::map<std::string, Bytes> answers_;  // By request.
};

}  // namespace aeolic
