// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report/measurements.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace toile::bench {
namespace {

using nlohmann::json;

double secondsPer(const std::string& unit) {
    constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
        {{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1}}};
    for (const auto& [name, seconds] : kUnits) {
        if (unit == name) {
            return seconds;
        }
    }
    throw std::runtime_error("unknown unit of time: " + unit);
}

/// What Google Benchmark writes of each run beside its counters.
bool isCounter(const std::string& key) {
    static const std::array kOwn{"family_index",     "per_family_instance_index",
                                 "repetitions",      "repetition_index",
                                 "threads",          "iterations",
                                 "real_time",        "cpu_time",
                                 "items_per_second", "bytes_per_second"};
    return std::find(kOwn.begin(), kOwn.end(), key) == kOwn.end();
}

/// Google Benchmark writes numbers that JSON does not have, where a counter's deviation is divided
/// by its mean of zero.
std::string withoutNaN(std::string text) {
    for (const std::string_view word : {"-Infinity", "Infinity", "NaN"}) {
        const std::string value = ": " + std::string(word);
        for (std::size_t at = text.find(value); at != text.npos; at = text.find(value, at)) {
            text.replace(at, value.size(), ": null");
        }
    }
    return text;
}

void addRun(const json& run, Measurements& measurements) {
    if (run.value("run_type", "iteration") != "iteration" || run.value("error_occurred", false)) {
        return;
    }
    const double unit = secondsPer(run.at("time_unit").get<std::string>());
    std::map<std::string, double> counters;
    for (const auto& [key, value] : run.items()) {
        if (value.is_number() && isCounter(key)) {
            counters[key] = value.get<double>();
        }
    }
    measurements.add(run.at("name").get<std::string>(), unit * run.at("cpu_time").get<double>(),
                     unit * run.at("real_time").get<double>(), counters);
}

double lowestOf(const std::vector<double>& seconds) {
    return *std::min_element(seconds.begin(), seconds.end());
}

double medianOf(std::vector<double> sorted) {
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

}  // namespace

double Measurement::lowest() const {
    return lowestOf(seconds);
}

double Measurement::median() const {
    return medianOf(seconds);
}

double Measurement::lowestWall() const {
    return lowestOf(wallSeconds);
}

double Measurement::medianWall() const {
    return medianOf(wallSeconds);
}

std::string plainName(std::string_view fullName) {
    std::string name;
    while (!fullName.empty()) {
        const std::size_t end = std::min(fullName.find('/'), fullName.size());
        const std::string_view part = fullName.substr(0, end);
        fullName.remove_prefix(std::min(end + 1, fullName.size()));
        const bool added = part.find(':') != part.npos || part == "real_time" ||
                           part == "process_time" || part == "manual_time";
        if (!added) {
            name.append(name.empty() ? "" : "/").append(part);
        }
    }
    return name;
}

void Measurements::add(std::string_view fullName, double cpuSeconds, double realSeconds,
                       const std::map<std::string, double>& counters) {
    const bool wall = fullName.find("/real_time") != fullName.npos;
    Measurement& measurement = all_[plainName(fullName)];
    measurement.seconds.push_back(wall ? realSeconds : cpuSeconds);
    measurement.wallSeconds.push_back(realSeconds);
    for (const auto& [key, value] : counters) {
        const auto [found, isNew] = measurement.counters.emplace(key, value);
        found->second = std::min(found->second, value);
    }
}

const Measurement* Measurements::find(const std::string& name) const {
    const auto found = all_.find(name);
    return found == all_.end() ? nullptr : &found->second;
}

std::optional<double> Measurements::lowest(const std::string& name) const {
    const Measurement* found = find(name);
    return found == nullptr ? std::nullopt : std::optional(found->lowest());
}

std::optional<double> Measurements::counter(const std::string& name,
                                            const std::string& counter) const {
    const Measurement* measurement = find(name);
    if (measurement == nullptr) {
        return std::nullopt;
    }
    const auto found = measurement->counters.find(counter);
    return found == measurement->counters.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> Measurements::ratio(const std::string& name, const std::string& to) const {
    const auto mine = lowest(name), theirs = lowest(to);
    return mine && theirs ? std::optional(*mine / *theirs) : std::nullopt;
}

std::optional<double> Measurements::wallRatio(const std::string& name,
                                              const std::string& to) const {
    const Measurement *mine = find(name), *theirs = find(to);
    return mine != nullptr && theirs != nullptr
               ? std::optional(mine->lowestWall() / theirs->lowestWall())
               : std::nullopt;
}

std::optional<Measurements::Floor> Measurements::floorOf(const std::string& piece) const {
    const std::string prefix = "floor/" + piece + "/";
    std::optional<Floor> lowest;
    for (auto it = all_.lower_bound(prefix); it != all_.end() && it->first.starts_with(prefix);
         ++it) {
        if (!lowest || it->second.lowest() < lowest->measurement->lowest()) {
            lowest = Floor{it->first.substr(prefix.size()), &it->second};
        }
    }
    return lowest;
}

Measurements readRun(std::string_view text) {
    Measurements measurements;
    try {
        const json file = json::parse(withoutNaN(std::string(text)));
        for (const auto& [key, value] : file.at("context").items()) {
            if (value.is_string()) {
                measurements.machine[key] = value.get<std::string>();
            }
        }
        for (const json& run : file.at("benchmarks")) {
            addRun(run, measurements);
        }
    } catch (const json::exception& error) {
        throw std::runtime_error(std::string("not a run of the benchmarks: ") + error.what());
    }
    return measurements;
}

}  // namespace toile::bench
