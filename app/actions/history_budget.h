// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstddef>

namespace toile {

class Document;

/// Keeps what the steps of the history hold within bounds: scenes and results of states far from
/// the present one go, scenes before results, and are made again when such a state comes back
/// (Workspace). What states share is counted once, and not at all where the present state has it.
/// Garments are not counted: they could only be read again. GUI thread only.
class HistoryBudget : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

    /// @param document must outlive this
    explicit HistoryBudget(Document& document, QObject* parent = nullptr);

    void setMostBytes(std::size_t most);

private:
    /// Cost: steps times pieces, of pointers.
    void keep();

    Document& document_;
    std::size_t most_ = kMostBytes;
};

}  // namespace toile
