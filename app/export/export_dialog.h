// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <functional>
#include <memory>

#include "core/formats/formats.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QStackedWidget;

namespace toile::app {

class DrawingPreview;
class OptionForm;
class PieceChoice;

/// Questions that the dialog delegates.
struct ExportQuestions {
    /// Asks for a file from a suggestion and a filter; empty if cancelled.
    std::function<QString(QWidget* parent, const QString& suggestion, const QString& filter)> save;
    /// Asks whether to replace an existing file.
    std::function<bool(QWidget* parent, const QString& path)> mayReplace;
};

struct ExportChoice {
    QString path;    ///< with extension
    QString format;  ///< usual extension of the format, ".svg"
    ExportOptions options;
    bool showsFolder = false;
    bool onlySelected = false;  ///< export only the selected pieces
};

/// Chooses format, options and file of an exported pattern. The preview shows the page or, for text
/// formats, the start of the file.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param path    suggestion without extension  @param format  an extension as in ExportChoice
    ExportDialog(const QString& path, const QString& format, const ExportOptions& options,
                 ExportQuestions questions, QWidget* parent);

    /// Offers a choice between all and the selected pieces; hidden if `count` is 0.
    /// @param chosen  initially the selected ones
    void offerSelected(int count, bool chosen);
    /// Sets the finished drawing.
    void setPattern(const std::shared_ptr<const DrawnPattern>& pattern);
    /// Sets the start of a file; ignored if another format is chosen by now.
    void setText(FormatId format, const QString& text);
    ExportChoice choice() const;

    void accept() override;

signals:
    /// The choice of pieces has changed; `setPattern` is expected.
    void piecesChanged();
    /// The preview needs the start of such a file (`setText`).
    void textWanted(toile::FormatId format, const toile::ExportOptions& options);

private:
    const Format& format() const;
    QWidget* makeTarget();
    void fillFormats();
    void onFormat();
    void onPathEdited();
    void browse();
    void describe();
    void showFile();

    std::vector<const Format*> formats_;  ///< the writable formats, by row
    std::shared_ptr<const Drawing> drawing_;
    ExportQuestions questions_;
    QString browsed_;  ///< from the file dialog, which already asked about replacing it
    QListWidget* list_;
    OptionForm* form_;
    QStackedWidget* shown_;
    DrawingPreview* preview_;
    QPlainTextEdit* text_;
    QLabel *use_, *page_, *notes_;
    PieceChoice* pieces_;
    QLineEdit* path_ = nullptr;
    QCheckBox* folder_ = nullptr;
    QPushButton* export_ = nullptr;
};

}  // namespace toile::app
