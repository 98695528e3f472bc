// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/plain_scan.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace toile::bench {
namespace {

std::string wholeFile(const std::filesystem::path& path) {
    std::string text(std::filesystem::file_size(path), '\0');
    std::ifstream(path, std::ios::binary)
        .read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
}

template <class Number>
void takeNumbers(const char* p, const char* end, std::vector<Number>& numbers) {
    while (p < end) {
        Number number{};
        const auto [last, status] = std::from_chars(p, end, number);
        if (status == std::errc()) {
            numbers.push_back(number);
            p = last;
        }
        ++p;  // a blank or a slash
    }
}

}  // namespace

PlainNumbers scanPlainly(const std::filesystem::path& path) {
    const std::string file = wholeFile(path);
    PlainNumbers numbers;
    for (std::string_view text = file; !text.empty();) {
        const std::string_view line = text.substr(0, text.find('\n'));
        const char* const end = line.data() + line.size();
        if (line.starts_with("v ")) {
            takeNumbers(line.data() + 2, end, numbers.positions);
        } else if (line.starts_with("vt ")) {
            takeNumbers(line.data() + 3, end, numbers.uvs);
        } else if (line.starts_with("f ")) {
            takeNumbers(line.data() + 2, end, numbers.indices);
        }
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return numbers;
}

}  // namespace toile::bench
