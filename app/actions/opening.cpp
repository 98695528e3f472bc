// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/opening.h"

#include <utility>

namespace toile {

void Opening::begin() {
    files_.reset();
    active_ = true;
    edited_ = false;
    ++number_;
}

void Opening::begin(Files files) {
    begin();
    files_ = std::move(files);
}

void Opening::stop() {
    files_.reset();
    active_ = false;
}

Opening::Next Opening::arrive(Next open) {
    stop();
    Next once = [this, open = std::move(open), number = number_] {
        if (number == number_) {
            ++number_;  // an answer is good for one opening
            open();
        }
    };
    if (!std::exchange(edited_, false) || !ask_) {
        return once;
    }
    return [this, once = std::move(once)] { ask_(once); };
}

}  // namespace toile
