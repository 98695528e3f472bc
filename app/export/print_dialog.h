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

/// On which paper the pattern is printed, with a picture of every sheet. The choices are those of
/// PDF files. Which printer, is asked after it.
class PrintDialog : public QDialog {
    Q_OBJECT

public:
    /// @param hasPrinter  without one there is only a PDF file to be had
    PrintDialog(const ExportOptions& options, bool hasPrinter, QWidget* parent);

    /// Lets the person choose between all pieces and so many that are selected; with none there is
    /// no choice.
    void offerSelected(int count);
    bool isSelectedOnly() const;
    /// What is printed, once it is drawn; null until then.
    void setPattern(std::shared_ptr<const InkedPattern> pattern);
    const ExportOptions& options() const;
    /// The sheets as they are chosen now; null where there are none, or not yet.
    std::shared_ptr<const PrintedPattern> sheets() const { return sheets_; }
    /// Says why these cannot be printed; until something else is chosen.
    void say(const QString& sentence);

signals:
    /// Others are to be printed: they are to be drawn (`setPattern`).
    void piecesChanged();
    /// Only where `sheets` has some.
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
