// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

namespace toile {

/// What the window shows before a garment is open: a friendly word, how to open one, the samples.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);

signals:
    void openWanted();
    void sampleWanted(const QString& path);

private:
    QWidget* makeSamples();
};

/// The sample garments that came with the program, or lie in its source tree; may be empty.
QStringList samplePaths();

}  // namespace toile
