// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/workspace.h"

#include <algorithm>
#include <utility>

#include "app/jobs/export_job.h"
#include "app/jobs/flatten_job.h"
#include "app/jobs/import_job.h"
#include "core/base/file.h"

namespace toile {

Workspace::Workspace(QObject* parent) : QObject(parent) {
    connect(&document_, &Document::changed, this, &Workspace::onChanged);
    connect(&jobs_, &JobRunner::failed, this, &Workspace::onOver);
    connect(&jobs_, &JobRunner::cancelled, this, &Workspace::onOver);
}

Workspace::~Workspace() {
    jobs_.shutdown();
}

void Workspace::open(Paths files) {
    if (files.empty()) {
        return;
    }
    if (!requested_.empty() && files != requested_) {
        loading_.unit.reset();
        loading_.up.reset();
        loading_.seams = {};
        if (loading_.split == SplitMode::Seams) {
            loading_.split = SplitMode::Auto;
        }
    }
    requested_ = std::move(files);
    read();
}

void Workspace::reload() {
    read();
}

void Workspace::read() {
    emit loadingChanged();
    if (!requested_.empty()) {
        importing_ = true;
        jobs_.replace(std::make_unique<ImportJob>(document_, requested_, loading_));
    }
}

void Workspace::setLoading(LoadOptions loading) {
    loading_ = std::move(loading);
    read();
}

template <class Value>
void Workspace::change(Value LoadOptions::*field, const Value& value) {
    if (loading_.*field != value) {
        loading_.*field = value;
        read();
    }
}

void Workspace::setUnit(std::optional<LengthUnit> unit) {
    change(&LoadOptions::unit, unit);
}

void Workspace::setUpAxis(std::optional<UpAxis> up) {
    change(&LoadOptions::up, up);
}

void Workspace::setSplit(SplitMode split) {
    change(&LoadOptions::split, split);
}

void Workspace::setAutoCut(bool on) {
    change(&LoadOptions::autoCut, on);
}

void Workspace::setWeld(bool on) {
    change(&LoadOptions::weld, on);
}

Result<void> Workspace::readSeams(const std::filesystem::path& path) {
    auto seams = readSeamsFile(path);
    if (!seams) {
        return seams.error();
    }
    loading_.seams = std::move(*seams);
    read();
    return {};
}

Result<void> Workspace::writeSeams(const std::filesystem::path& path) const {
    return writeFile(path, writeSeamsFile(loading_.seams));
}

void Workspace::removeCut(const std::string& name) {
    std::vector<UserCut>& cuts = loading_.seams.cuts;
    const auto cut = std::ranges::find(cuts, name, &UserCut::name);
    if (cut == cuts.end()) {
        return;
    }
    cuts.erase(cut);
    if (cuts.empty() && loading_.split == SplitMode::Seams) {
        loading_.split = SplitMode::Auto;
    }
    read();
}

void Workspace::setEase(int seam, std::optional<double> ease) {
    const std::string name = document_.garment()->seams.seams[static_cast<std::size_t>(seam)].name;
    const auto note = [&](LoadOptions& options) {
        if (ease) {
            options.seams.ease[name] = *ease;
        } else {
            options.seams.ease.erase(name);
        }
    };
    note(loaded_);
    document_.setSeamEase(seam, ease);
    if (requested_ == openPaths()) {
        note(loading_);
        if (importing_) {
            read();  // the reading under way does not know of it
        }
    }
}

void Workspace::setMethod(Method method) {
    FlattenOptions options = document_.options();
    options.method = method;
    document_.setOptions(options);
}

void Workspace::setQuality(Quality quality) {
    FlattenOptions options = document_.options();
    options.quality = quality;
    document_.setOptions(options);
}

void Workspace::setBoundarySolver(BoundarySolver solver) {
    FlattenOptions options = document_.options();
    options.boundarySolver = solver;
    document_.setOptions(options);
}

void Workspace::flattenAgain() {
    // While a garment is being read, flattening follows by itself.
    if (document_.garment() && !importing_) {
        jobs_.replace(std::make_unique<FlattenJob>(document_));
    }
}

bool Workspace::canExport() const {
    return !document_.results().empty();
}

void Workspace::exportTo(const std::filesystem::path& path) {
    Q_ASSERT(canExport());
    jobs_.start(
        std::make_unique<ExportJob>(document_, path, [this](const std::filesystem::path& written) {
            emit exported(QString::fromStdU16String(written.u16string()));
        }));
}

void Workspace::onChanged(DocumentChanges what) {
    if (what.testFlag(DocumentChange::Garment)) {
        importing_ = false;
        loaded_ = loading_;
    }
    if (what & (DocumentChange::Garment | DocumentChange::Options)) {
        flattenAgain();
    }
}

void Workspace::onOver() {
    // A job that makes room for a reading says nothing about the reading.
    if (jobs_.hasWaiting() || !std::exchange(importing_, false)) {
        return;
    }
    requested_ = openPaths();
    if (document_.garment()) {
        // What was asked for did not come: the garment is still as it was read.
        loading_ = loaded_;
        emit loadingChanged();
    }
}

Workspace::Paths Workspace::openPaths() const {
    Paths paths;
    if (document_.garment()) {
        for (const auto& file : document_.garment()->files) {
            paths.push_back(file->path);
        }
    }
    return paths;
}

}  // namespace toile
