// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toile::bench {

/// What one benchmark measured. Its time is processor time, or wall-clock time where it says so in
/// its name ("/real_time"): the work of several threads, files, other programs.
struct Measurement {
    std::vector<double> seconds;             ///< of each repetition
    std::vector<double> wallSeconds;         ///< the same by the clock on the wall
    std::map<std::string, double> counters;  ///< the lowest of all repetitions

    double lowest() const;
    double median() const;
    double lowestWall() const;
    double medianWall() const;
};

/// What one run measured, by names such as "curvature/panel/45000": what, on which piece, of how
/// many triangles, and how. Ratios are taken between the lowest times: what other programs on the
/// machine disturb least.
class Measurements {
public:
    std::map<std::string, std::string> machine;  ///< where and with what it was measured

    /// @param fullName  as Google Benchmark prints it
    void add(std::string_view fullName, double cpuSeconds, double realSeconds,
             const std::map<std::string, double>& counters);

    const std::map<std::string, Measurement>& all() const { return all_; }
    const Measurement* find(const std::string& name) const;
    std::optional<double> lowest(const std::string& name) const;
    std::optional<double> counter(const std::string& name, const std::string& counter) const;
    std::optional<double> ratio(const std::string& name, const std::string& to) const;
    std::optional<double> wallRatio(const std::string& name, const std::string& to) const;

    /// The fastest of the floor's candidates for a piece ("panel/45000"): "floor/panel/45000/...".
    struct Floor {
        std::string candidate;
        const Measurement* measurement;
    };
    std::optional<Floor> floorOf(const std::string& piece) const;

private:
    std::map<std::string, Measurement> all_;
};

/// The name without what Google Benchmark adds to it ("/repeats:5", "/real_time").
std::string plainName(std::string_view fullName);

/// Reads the file that `--benchmark_out` has written. Means and deviations, and what ended with an
/// error, are left out. Throws std::runtime_error where it is no such file.
Measurements readRun(std::string_view json);

}  // namespace toile::bench
