#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reader/tecplot/tecplot_text.h"

namespace aeolic {

/// Passes through a file's text, and keeps what its records say. Numbers are passed over. Throws InputError.
class TecplotHeads {
public:
    TecplotHeads(std::string_view text, const std::string& path) : text_(text), path_(path) {}

    void read();

    std::vector<std::string> variables;
    std::vector<TecplotZone> zones;

private:
    void skipBlank();
    bool atRecord() const;
    std::string word();
    std::string value();
    std::string quoted();
    void skipToRecord();
    void readVariables();
    void readZone();
    void setKey(TecplotZone& zone, const std::string& key, const std::string& value);
    void setType(TecplotZone& zone, const std::string& key, const std::string& value);
    std::vector<std::size_t> numbersIn(std::string_view list, std::size_t most) const;
    void setLocations(TecplotZone& zone, const std::string& value) const;
    void setShared(TecplotZone& zone, const std::string& value) const;
    std::int64_t whole(const std::string& key, const std::string& value) const;
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

    std::string_view text_;
    const std::string& path_;
    std::size_t at_ = 0;
};

}  // namespace aeolic
