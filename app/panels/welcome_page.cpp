// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/welcome_page.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/widgets/icon.h"

namespace toile {

namespace {

constexpr int kColumnWidth = 520;

QLabel* makeText(const QString& text, double scale, bool bold, bool faint) {
    auto* label = new QLabel(text);
    label->setAlignment(Qt::AlignHCenter);
    label->setWordWrap(true);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    if (bold) {
        font.setWeight(QFont::DemiBold);
    }
    label->setFont(font);
    if (faint) {
        QPalette palette = label->palette();
        QColor colour = palette.color(QPalette::WindowText);
        colour.setAlphaF(0.70F);
        palette.setColor(QPalette::WindowText, colour);
        label->setPalette(palette);
    }
    return label;
}

/// "tshirt" is "T-shirt" to a person; other file names only get a capital.
QString sampleTitle(const QString& path) {
    const QString base = QFileInfo(path).completeBaseName();
    if (base == "tshirt") {
        return QCoreApplication::translate("WelcomePage", "T-shirt");
    }
    QString title = base;
    title.replace('_', ' ').replace('-', ' ');
    return title.left(1).toUpper() + title.mid(1);
}

}  // namespace

QStringList samplePaths() {
    QStringList folders = {
        QDir(QCoreApplication::applicationDirPath()).filePath("../share/toile/samples"),
        QDir(QCoreApplication::applicationDirPath()).filePath("samples")};
#ifdef TOILE_SAMPLES_DIR
    folders << TOILE_SAMPLES_DIR;
#endif
    for (const QString& folder : folders) {
        QStringList paths;
        const QFileInfoList files = QDir(folder).entryInfoList({"*.obj"}, QDir::Files, QDir::Name);
        for (const QFileInfo& file : files) {
            paths << file.absoluteFilePath();
        }
        if (!paths.isEmpty()) {
            return paths;
        }
    }
    return {};
}

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent) {
    setObjectName("welcome");
    auto* mark = new QLabel;
    mark->setPixmap(QIcon(":/icons/toile.svg").pixmap(QSize(76, 76), devicePixelRatioF()));
    mark->setAlignment(Qt::AlignHCenter);
    mark->setMinimumHeight(76);
    auto* open = new QPushButton(themedIcon("open"), tr("Open a garment…"));
    open->setObjectName("welcomeOpen");
    open->setDefault(true);
    open->setMinimumHeight(38);
    open->setIconSize({20, 20});
    connect(open, &QPushButton::clicked, this, &WelcomePage::openWanted);

    auto* column = new QWidget;
    column->setFixedWidth(kColumnWidth);
    auto* lines = new QVBoxLayout(column);
    lines->setSpacing(8);
    lines->addWidget(mark);
    lines->addSpacing(16);
    lines->addWidget(makeText(tr("From a 3D garment to a sewing pattern"), 1.7, true, false));
    lines->addWidget(makeText(tr("Toile flattens every piece of a garment so that its seam lines "
                                 "keep their length, and shows what the cloth has to do."),
                              1.05, false, true));
    lines->addSpacing(16);
    lines->addWidget(open, 0, Qt::AlignHCenter);
    lines->addWidget(makeText(tr("or drop OBJ, PLY, OFF or STL files here; several files are "
                                 "taken as one garment"),
                              0.95, false, true));
    if (QWidget* samples = makeSamples()) {
        lines->addSpacing(26);
        lines->addWidget(makeText(tr("Or begin with a sample"), 1.0, true, false));
        lines->addWidget(samples, 0, Qt::AlignHCenter);
    }
    auto* layout = new QVBoxLayout(this);
    layout->addStretch(2);
    layout->addWidget(column, 0, Qt::AlignHCenter);
    layout->addStretch(3);
}

QWidget* WelcomePage::makeSamples() {
    const QStringList paths = samplePaths();
    if (paths.isEmpty()) {
        return nullptr;
    }
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    for (const QString& path : paths) {
        auto* button = new QPushButton(sampleTitle(path));
        button->setObjectName("sample-" + QFileInfo(path).completeBaseName());
        button->setToolTip(QDir::toNativeSeparators(path));
        button->setMinimumWidth(84);
        connect(button, &QPushButton::clicked, this, [this, path] { emit sampleWanted(path); });
        row->addWidget(button);
    }
    return box;
}

}  // namespace toile
