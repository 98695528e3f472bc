// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>

#include "app/document/document_state.h"
#include "app/widgets/setting_fields.h"

namespace toile::app {

class Workspace;

/// The steps that make a sheet of a scan, each to be done or not, over the garment as they leave
/// it: shown soon after every change, and flattened when the form is closed. All that is tried is
/// one step of the history, which Cancel takes out again. What is done elsewhere meanwhile closes
/// the form as it is.
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
    /// Something else is done: what is tried stays.
    void leave();

    Workspace& workspace_;
    DocumentState before_;
    int step_;  ///< of the history, before this
    int gesture_;
    bool isTrying_ = false;  ///< the history changes by this
    bool isLeft_ = false;
    QTimer soon_;
    ScanSteps steps_{}, usual_{};  ///< usual: lengths of steps that are off
    SettingFields fields_;
    QLabel* effect_;
};

}  // namespace toile::app
