// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "app/jobs/job.h"
#include "app/jobs/known_file.h"
#include "core/project/project.h"

namespace toile {

struct Scene;

/// Reads a project file and its meshes, and prepares what the 3D view shows of them.
class ProjectJob : public Job {
public:
    /// Where files are found that are not where the project says.
    using Found = std::map<std::filesystem::path, std::filesystem::path>;

    struct Opened {
        Project project;  ///< with the paths that were found
        std::shared_ptr<const Garment> garment;
        std::shared_ptr<const Scene> scene;
        Problems notes;   ///< what is other than it was when the project was saved
        KnownFile known;  ///< the project's file; of a recovery file the one that it is of
    };

    using Done = std::function<void(Opened)>;
    using Missing = std::function<void(const std::vector<std::filesystem::path>&)>;

    /// On the GUI thread one of the two is called.
    /// @param missing  meshes that are not there: nothing was opened
    ProjectJob(std::filesystem::path path, Found found, Done done, Missing missing);

    QString title() const override;
    Result<void> process(Progress& progress) override;
    void finalize() override;

private:
    std::filesystem::path path_;
    Found found_;
    Done done_;
    Missing missing_;
    Opened opened_;
    std::vector<std::filesystem::path> lost_;
};

}  // namespace toile
