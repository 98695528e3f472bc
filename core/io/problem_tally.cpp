// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/problem_tally.h"

#include <algorithm>

#include "core/base/text.h"

namespace toile {

void ProblemTally::add(ErrorCode code, std::string_view noun, std::string_view what, int place) {
    for (Entry& entry : entries_) {
        if (entry.code == code && entry.noun == noun && entry.what == what) {
            ++entry.count;
            entry.firstPlace = std::min(entry.firstPlace, place);
            return;
        }
    }
    entries_.push_back({code, noun, what, place, 1});
}

std::string ProblemTally::inWords(const Entry& entry) const {
    std::string text = counted(entry.count, entry.noun);
    text.append(" ").append(entry.what).append(entry.count == 1 ? ", " : ", first at ");
    return text.append(placeWord_) + " " + std::to_string(entry.firstPlace);
}

std::string ProblemTally::summary() const {
    std::string text;
    for (const Entry& entry : entries_) {
        text += (text.empty() ? "" : "; ") + inWords(entry);
    }
    return text;
}

Problems ProblemTally::problems(const std::string& file) const {
    Problems problems;
    for (const Entry& entry : entries_) {
        const auto same = std::find_if(problems.begin(), problems.end(),
                                       [&](const Error& e) { return e.code == entry.code; });
        if (same == problems.end()) {
            problems.push_back({entry.code, Subject::file(file), inWords(entry)});
        } else {
            same->detail += "; " + inWords(entry);
        }
    }
    return problems;
}

}  // namespace toile
