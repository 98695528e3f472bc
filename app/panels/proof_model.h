// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/widgets/columns_model.h"

namespace toile {
struct Proof;
}  // namespace toile

namespace toile::app {

class Document;
struct ShownProof;

/// The sewn pieces, one per row, with the results of each.
class ProofModel : public ColumnsModel {
    Q_OBJECT

public:
    enum Column { Name, Mean, Most, Largest, Pull, Slack, Free, ColumnCount };
    static constexpr int PieceRole = SortRole + 1;  ///< int: the piece

    explicit ProofModel(const Document& document, QObject* parent = nullptr);

    /// @param shown  null clears the table
    void show(std::shared_ptr<const ShownProof> shown);
    QVariant data(const QModelIndex& index, int role) const override;
    void writeAgain() { showAgain(); }

protected:
    std::vector<Heading> headings() const override;
    bool isWords(int column) const override { return column == Name; }
    Cell cell(int row, int column) const override;

private:
    const Document& document_;
    std::shared_ptr<const ShownProof> shown_;
    std::vector<int> pieces_;  ///< one per row
};

}  // namespace toile::app
