// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace toile::app {

class Preferences;

/// What the window shows before a garment is open: a friendly word, how to open one, what was
/// opened last, the samples.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    /// `preferences` must outlive the page.
    explicit WelcomePage(Preferences& preferences, QWidget* parent = nullptr);

signals:
    void openWanted();
    /// One that was opened before, or a sample.
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
    /// In the colour of the theme, which may change.
    void tintFaintTexts();

    Preferences& preferences_;
    QPushButton* open_ = nullptr;
    QLabel* advice_ = nullptr;   ///< what can be opened, or how to get it from where it is made
    QWidget* recent_ = nullptr;  ///< heading and list; hidden where nothing was opened yet
    QVBoxLayout* recentRows_ = nullptr;
};

}  // namespace toile::app
