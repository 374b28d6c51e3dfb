#include "reader/ensight/ensight_words.h"

namespace aeolic {

std::vector<std::string> ensightWords(const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    bool quoted = false, any = false;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\r';
        if (c == '"') {
            quoted = !quoted;
            any = true;
        } else if (quoted || !blank) {
            word += c;
            any = true;
        } else if (any) {
            words.push_back(word);
            word.clear();
            any = false;
        }
    }
    if (any) words.push_back(word);
    return words;
}

}  // namespace aeolic
