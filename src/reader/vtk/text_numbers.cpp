#include "reader/vtk/text_numbers.h"

#include <array>
#include <string_view>

#include "reader/binary/numbers.h"

namespace aeolic {
namespace {

constexpr std::size_t longestNumber = 400;

/// Whether each character may stand within a number, "nan" and "infinity" included.
constexpr auto isInNumber = [] {
    std::array<bool, 256> is{};
    for (const char c : std::string_view("0123456789+-.dDeEnNaAiIfFtTyY")) is[static_cast<unsigned char>(c)] = true;
    return is;
}();

class NumberReader : public std::num_get<char> {
protected:
    iter_type do_get(iter_type at, iter_type end, std::ios_base&, std::ios_base::iostate& state,
                     float& value) const override
    {
        return read(at, end, state, value);
    }

    iter_type do_get(iter_type at, iter_type end, std::ios_base&, std::ios_base::iostate& state,
                     double& value) const override
    {
        return read(at, end, state, value);
    }

private:
    template <class Real>
    static iter_type read(iter_type at, iter_type end, std::ios_base::iostate& state, Real& value)
    {
        std::array<char, longestNumber> text;
        std::size_t length = 0;
        for (; at != end && length < text.size() && isInNumber[static_cast<unsigned char>(*at)]; ++at)
            text[length++] = *at;
        value = 0;
        const char* const last = text.data() + length;
        const auto [stop, error] = readReal(text.data(), last, value);
        if (error != std::errc{} || stop != last) state |= std::ios_base::failbit;
        if (at == end) state |= std::ios_base::eofbit;
        return at;
    }
};

}  // namespace

const std::locale& textNumbers()
{
    static const std::locale locale(std::locale::classic(), new NumberReader);
    return locale;
}

}  // namespace aeolic
