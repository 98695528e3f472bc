// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>
#include <optional>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace toile::app {

class CutChart;
class CutProposals;

/// The proposed cuts: a chart of strain against length, a row for each cut, and buttons to apply
/// them. Closing the form discards the proposals. It closes itself when they are gone.
class ProposalsForm : public QDialog {
    Q_OBJECT

public:
    /// `proposals` must outlive this.
    ProposalsForm(CutProposals& proposals, QWidget* parent);

    void reject() override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QLayout* makeFields();
    QLayout* makeButtons();
    void refresh();
    void fill(QTreeWidgetItem& row, std::size_t cut);
    void showChart();
    void showSelection();
    QString saying() const;
    QString strainTip(std::size_t cut) const;
    std::optional<std::size_t> current() const;
    void makeCurrent();

    CutProposals& proposals_;
    QLabel* saying_;
    QProgressBar* progress_;
    CutChart* chart_;
    QTreeWidget* table_;
    QLineEdit* enough_;
    QPushButton *swap_, *make_;
    QTimer poll_;
    bool isFilling_ = false;
};

}  // namespace toile::app
