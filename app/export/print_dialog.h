// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>

#include "app/export/printed_pattern.h"
#include "core/formats/export_options.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace toile::app {

class OptionForm;
class PieceChoice;
class SheetPreview;

/// Chooses the paper of a printed pattern, with a preview of every sheet and the options of PDF
/// files. The printer is chosen afterwards.
class PrintDialog : public QDialog {
    Q_OBJECT

public:
    /// @param hasPrinter  false: only a PDF file can be made
    PrintDialog(const ExportOptions& options, bool hasPrinter, QWidget* parent);

    /// Offers a choice between all and the selected pieces; hidden if `count` is 0.
    void offerSelected(int count);
    bool isSelectedOnly() const;
    /// Sets the finished drawing; null while it is being made.
    void setPattern(std::shared_ptr<const InkedPattern> pattern);
    const ExportOptions& options() const;
    /// The sheets for the current options; null if there are none or not yet.
    std::shared_ptr<const PrintedPattern> sheets() const { return sheets_; }
    /// Explains why they cannot be printed, until an option changes.
    void say(const QString& sentence);

signals:
    /// The choice of pieces has changed; `setPattern` is expected.
    void piecesChanged();
    /// Emitted only if `sheets` is not null.
    void printWanted();
    void fileWanted();

private:
    QWidget* makePages();
    void layOut();

    std::shared_ptr<const InkedPattern> pattern_;
    std::shared_ptr<const PrintedPattern> sheets_;
    bool hasPrinter_;
    PieceChoice* pieces_;
    OptionForm* form_;
    SheetPreview* preview_;
    QLabel *summary_, *note_;
    QSpinBox* page_ = nullptr;
    QPushButton* print_ = nullptr;
};

}  // namespace toile::app
