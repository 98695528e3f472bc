// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/widgets/columns_model.h"
#include "core/seam/seam_measure.h"

namespace toile {
struct Garment;
struct Seam;
}  // namespace toile

namespace toile::app {

class Document;
class DocumentChange;

/// The document's seams and free edges as a table: row i is seam i, measured on the flat pieces.
/// The ease in percent is editable: the model emits `easeWanted` and then follows the document.
class SeamsModel : public ColumnsModel {
    Q_OBJECT

public:
    enum Column {
        Number,
        Name,
        Kind,
        Length3d,
        FlatLeft,
        FlatRight,
        Difference,
        Ease,
        Drawn,
        ChangedBy,
        Error,
        Fit,
        ColumnCount
    };
    static constexpr int FreeRole = SortRole + 1;  ///< bool: a free edge

    explicit SeamsModel(const Document& document, QObject* parent = nullptr);

    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    /// One line about all seams: "26 seams · worst 0.00 mm". Empty if there are none.
    QString summary() const;

signals:
    /// @param ease  fraction of the right side's length; none: derived from the 3D lengths
    void easeWanted(int seam, std::optional<double> ease);
    /// The user switched drawing of the stated ease in the pattern on or off.
    void drawingWanted(int seam, bool drawn);

protected:
    std::vector<Heading> headings() const override;
    bool isWords(int column) const override {
        return column == Name || column == Kind || column == Drawn || column == ChangedBy ||
               column == Fit;
    }
    Cell cell(int row, int column) const override;

private:
    QString edgeWord(int row) const;
    void onChanged(const DocumentChange& what);
    void measureAll();
    /// True if the seams and their order are unchanged.
    bool hasTheSameRows() const;
    const Seam& seam(int row) const;
    QString tip(int row, int column) const;
    QVariant background(int row, int column) const;

    const Document& document_;
    /// The garment whose seams the rows show. Until a reset begins, the one before the change.
    std::shared_ptr<const Garment> garment_;
    std::vector<std::optional<SeamMeasure>> measures_;  ///< one per seam
    std::vector<std::vector<LengthChange>> changes_;    ///< likewise
};

}  // namespace toile::app
