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

/// What the dialog asks beside itself.
struct ExportQuestions {
    /// Another place: a suggestion and a filter to a path that may be written to; empty for none.
    std::function<QString(QWidget* parent, const QString& suggestion, const QString& filter)> save;
    /// Whether a file that is there may be replaced.
    std::function<bool(QWidget* parent, const QString& path)> mayReplace;
};

struct ExportChoice {
    QString path;    ///< with an ending
    QString format;  ///< the usual ending of its format, ".svg"
    ExportOptions options;
    bool showsFolder = false;
    bool onlySelected = false;  ///< the selected pieces alone
};

/// In which format the pattern is written, how, and where to; with a picture of the page, or of a
/// format that is read as text with the beginning of the file.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param path    suggested, without an ending  @param format  an ending, as ExportChoice has
    /// it
    ExportDialog(const QString& path, const QString& format, const ExportOptions& options,
                 ExportQuestions questions, QWidget* parent);

    /// Lets the person choose between all pieces and so many that are selected; with none there is
    /// no choice. @param chosen  these, at first
    void offerSelected(int count, bool chosen);
    /// The page, once it is drawn.
    void setPattern(const std::shared_ptr<const DrawnPattern>& pattern);
    /// The beginning of a file; nothing where another format is chosen by now.
    void setText(FormatId format, const QString& text);
    ExportChoice choice() const;

    void accept() override;

signals:
    /// Others are to be written: they are to be drawn (`setPattern`).
    void piecesChanged();
    /// The beginning of such a file is to be shown (`setText`).
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

    std::vector<const Format*> formats_;  ///< that can be written, by rows
    std::shared_ptr<const Drawing> drawing_;
    ExportQuestions questions_;
    QString browsed_;  ///< chosen in the dialog of files, which has asked whether to replace it
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
