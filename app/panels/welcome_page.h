// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace toile::app {

class Preferences;

/// Page shown until a garment is open: a greeting, how to open a file, recent files and samples.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    /// `preferences` must outlive the page.
    explicit WelcomePage(Preferences& preferences, QWidget* parent = nullptr);

signals:
    void openWanted();
    /// The user chose a recent file or a sample.
    void filesWanted(const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeOrigins();
    QWidget* makeSamples();
    QWidget* makeRecent();
    void updateRecent();
    /// Uses the theme's text colour, which may change.
    void tintFaintTexts();

    Preferences& preferences_;
    QPushButton* open_ = nullptr;
    QLabel* advice_ = nullptr;   ///< what can be opened, or how to export from another program
    QWidget* recent_ = nullptr;  ///< heading and list; hidden if nothing was opened yet
    QVBoxLayout* recentRows_ = nullptr;
};

}  // namespace toile::app
