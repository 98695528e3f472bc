// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace toile {

class PdfFile;

/// Lines of text as forms, each stored once per file: filled outlines of its letters, and the same
/// text invisibly, for searching. From (0, 0) on the baseline to the right.
class PdfLetters {
public:
    /// Height of a capital, in the unit of the forms; outlines are in whole units.
    static constexpr double kHeight = 1000;

    struct Line {
        std::string key;   ///< in resources; empty: nothing visible
        double width = 0;  ///< in the unit of the forms
        std::string content{};
    };

    /// Cost: that of `textOutlines` for a new line.
    const Line& line(std::string_view text);

    /// Writes the forms. @param font  the resource entry for searchable text
    /// @return their entries of a dictionary "/XObject"
    std::string addTo(PdfFile& file, const std::string& font) const;

private:
    std::map<std::string, Line, std::less<>> lines_;
    int count_ = 0;
};

}  // namespace toile
