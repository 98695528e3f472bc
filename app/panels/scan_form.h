// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>

#include "app/document/document_state.h"
#include "app/widgets/setting_fields.h"

namespace toile::app {

class Workspace;

/// Edits the steps that prepare a scan; each step is optional. The views show the result soon after
/// every change, and closing the form flattens it. All attempts form one undo step, which Cancel
/// removes. Any other edit of the document closes the form and keeps the last attempt.
class ScanForm : public QDialog {
    Q_OBJECT

public:
    /// Reads the open garment as a scan. The workspace must outlive this.
    ScanForm(Workspace& workspace, QWidget* parent);

    void accept() override;
    void reject() override;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void makeLayout();
    void setSteps(const ScanSteps& steps);
    /// Reads the garment with the current steps at once.
    void tryNow();
    void showEffect();
    /// Another edit was made: closes the form and keeps the last attempt.
    void leave();

    Workspace& workspace_;
    DocumentState before_;
    int step_;  ///< undo index before this form
    int gesture_;
    bool isTrying_ = false;  ///< this form is changing the history
    bool isLeft_ = false;
    QTimer soon_;
    ScanSteps steps_{}, usual_{};  ///< usual: values shown for steps that are off
    SettingFields fields_;
    QLabel* effect_;
};

}  // namespace toile::app
