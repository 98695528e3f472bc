// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/document/document_state.h"
#include "app/document/view_state.h"
#include "app/jobs/job.h"
#include "app/jobs/known_file.h"

namespace toile {

class Document;

/// Writes the open document as a project file. What it takes is a snapshot: edits may go on.
class SaveJob : public Job {
public:
    /// Whether the file is as it is to be. Not written is only what others have changed.
    enum class Outcome { Written, ChangedByOthers };
    using Done = std::function<void(Outcome)>;

    struct Target {
        std::filesystem::path path{};
        /// Where this is no saving but a recovery file: the project's path or none.
        std::optional<std::filesystem::path> recoveryOf{};
        /// What is known of the files that are written; none: is not asked about. Where the path is
        /// the known one and others have changed it, nothing is written; else it is known now.
        std::shared_ptr<KnownFile> known{};
        bool overwrite = false;  ///< what others have changed too
    };

    /// Takes its snapshot here. Requires an open garment.
    /// @param done  called on the GUI thread, and not where the file cannot be written
    SaveJob(const Document& document, Target target, Done done);

    QString title() const override;
    bool isCancellable() const override { return false; }
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    DocumentState state_;
    ViewState view_;
    Target target_;
    Outcome outcome_ = Outcome::Written;
    Done done_;
};

}  // namespace toile
