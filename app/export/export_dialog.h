// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>

#include "app/actions/file_dialogs.h"
#include "core/export/formats.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace toile::app {

class DrawingPreview;
class OptionForm;

struct ExportChoice {
    QString path;    ///< with an ending
    QString format;  ///< the usual ending of its format, ".svg"
    ExportOptions options;
    bool showsFolder = false;
};

/// In which format the pattern is written, how, and where to; with a picture of the page.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param path    suggested, without an ending  @param format  an ending, as ExportChoice has
    /// it
    /// @param dialogs  for another place; must outlive this
    ExportDialog(const QString& path, const QString& format, const ExportOptions& options,
                 const FileDialogs& dialogs, QWidget* parent);

    /// The page, once it is drawn.
    void setDrawing(std::shared_ptr<const Drawing> drawing);
    ExportChoice choice() const;

    void accept() override;

private:
    const Format& format() const;
    QWidget* makeTarget();
    void fillFormats();
    void onFormat();
    void onPathEdited();
    void browse();
    void describe();

    std::vector<const Format*> formats_;  ///< that can be written, by rows
    std::shared_ptr<const Drawing> drawing_;
    const FileDialogs& dialogs_;
    QString browsed_;  ///< chosen in the dialog of files, which has asked whether to replace it
    QListWidget* list_;
    OptionForm* form_;
    DrawingPreview* preview_;
    QLabel *use_, *page_;
    QLineEdit* path_ = nullptr;
    QCheckBox* folder_ = nullptr;
    QPushButton* export_ = nullptr;
};

}  // namespace toile::app
