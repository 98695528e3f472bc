// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/history_budget.h"

#include <QUndoStack>
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <unordered_set>
#include <vector>

#include "app/document/document.h"
#include "app/render/scene.h"

namespace toile {

namespace {

std::size_t bytesOf(const PieceResult& result) {
    return sizeof(PieceResult) +
           (result.flat ? static_cast<std::size_t>(result.flat->Q.size()) * sizeof(double) : 0);
}

/// Adds up what nobody has shown it before.
class Tally {
public:
    void add(const PieceResults& results) {
        if (results == last_) {
            return;  // most steps change none
        }
        for (const auto& result : results) {
            if (result && seen_.insert(result.get()).second) {
                bytes_ += bytesOf(*result);
            }
        }
        last_ = results;
    }

    void add(const std::shared_ptr<const Scene>& scene) {
        if (scene && seen_.insert(scene.get()).second) {
            bytes_ += toile::bytesOf(*scene);
        }
    }

    void passBy(const DocumentState& state) {
        add(state.results);
        add(state.scene);
        bytes_ = 0;
    }

    std::size_t bytes() const { return bytes_; }

private:
    std::unordered_set<const void*> seen_;
    PieceResults last_;
    std::size_t bytes_ = 0;
};

/// The steps, those next to the present state first.
std::vector<int> nearestFirst(const QUndoStack& history) {
    std::vector<int> steps(static_cast<std::size_t>(history.count()));
    std::iota(steps.begin(), steps.end(), 0);
    const int now = history.index();
    std::ranges::stable_sort(
        steps, {}, [now](int step) -> int { return step < now ? now - step : step - now + 1; });
    return steps;
}

}  // namespace

HistoryBudget::HistoryBudget(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document_.history(), &QUndoStack::indexChanged, this, &HistoryBudget::keep);
    connect(&document_, &Document::changed, this, [this](DocumentChanges what) {
        if (what.testFlag(DocumentChange::Results)) {
            keep();  // the present state does not share any more what it did
        }
    });
}

void HistoryBudget::setMostBytes(std::size_t most) {
    most_ = most;
    keep();
}

void HistoryBudget::keep() {
    Tally tally;
    tally.passBy(document_.state());
    const std::vector<int> steps = nearestFirst(document_.history());
    for (const int step : steps) {
        tally.add(document_.keptState(step).results);
        if (tally.bytes() > most_) {
            document_.letGo(step, true);
        }
    }
    for (const int step : steps) {
        if (tally.bytes() <= most_) {
            tally.add(document_.keptState(step).scene);
        }
        if (tally.bytes() > most_) {
            document_.letGo(step, false);
        }
    }
}

}  // namespace toile
