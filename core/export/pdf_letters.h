// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace toile {

class PdfFile;

/// Lines of text as forms, each once in a file however often it is shown: outlines of its letters,
/// filled, and the same text unseen, to be searched for. From (0, 0) on the baseline to the right.
class PdfLetters {
public:
    /// Of a capital, in the unit of the forms; outlines are in whole units.
    static constexpr double kHeight = 1000;

    struct Line {
        std::string key;   ///< in resources; empty: nothing is seen of it
        double width = 0;  ///< in the unit of the forms
        std::string content{};
    };

    /// Cost: that of `textOutlines`, for a line that is new.
    const Line& line(std::string_view text);

    /// Writes the forms. @param font  the entry of resources for what is searched for
    /// @return their entries of a dictionary "/XObject"
    std::string addTo(PdfFile& file, const std::string& font) const;

private:
    std::map<std::string, Line, std::less<>> lines_;
    int count_ = 0;
};

}  // namespace toile
