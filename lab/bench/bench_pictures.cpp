#include "lab/bench/bench_pictures.h"

#include "lab/progress.h"
#include "lab/results/result_pictures.h"

#include <algorithm>

namespace gnomon {

BenchPictures::BenchPictures(const BenchPlan& plan, std::size_t contexts) : plan_(plan), contexts_(contexts) {}

void BenchPictures::draw(BenchRun& run, Problems& problems) {
    const std::vector<BenchCost>& costs = run.costs();
    std::vector<std::size_t> indices(costs.size());
    std::size_t count = drawn_.size();
    const std::size_t known = problems.size();
    for (std::size_t i = 0; i < costs.size(); ++i) indices[i] = costs[i].drawn ? count++ : kNone;
    for (std::size_t i = 0; i < costs.size() && !LabProgress::interrupted() && problems.size() == known; ++i) {
        const glm::ivec2 size = pictureSize(plan_.entries[i].settings.size, contexts_ * plan_.entries.size());
        if (costs[i].drawn) drawn_.push_back({run.picture(i, size, problems), indices[plan_.baselines[i]]});
    }
}

void BenchPictures::addTo(Results& results) const {
    const Table& table = results.tables.front();
    const auto keysOf = [&](std::size_t row) {
        return std::vector<Cell>(table.rows[row].begin(), table.rows[row].begin() + table.keys);
    };
    const auto titleOf = [&](std::size_t row) {
        std::string title;
        for (const Cell& cell : keysOf(row)) title += (title.empty() ? "" : ", ") + shown(cell);
        return title;
    };
    for (std::size_t i = 0; i < std::min(drawn_.size(), table.rows.size()); ++i) {
        const std::size_t baseline = drawn_[i].baseline;
        const bool beside = baseline < drawn_.size() && baseline != i;
        addPicture({titleOf(i), table.name, keysOf(i), 0, {}, beside ? titleOf(baseline) : std::string()},
                   drawn_[i].image, beside ? drawn_[baseline].image : Image{}, results);
    }
}

} // namespace gnomon
