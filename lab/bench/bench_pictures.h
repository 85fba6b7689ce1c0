/// What the rows of `gnomon bench` look like, each beside its baseline.
#pragma once

#include "lab/bench/bench_run.h"
#include "lab/results/results.h"
#include "tracer/image.h"

#include <vector>

namespace gnomon {

class BenchPictures {
  public:
    /// Of so many contexts, which share what a file may hold. The plan has to outlive it.
    BenchPictures(const BenchPlan&, std::size_t contexts);

    /// Every entry that was drawn in one of them; as many as the user waits for.
    void draw(BenchRun&, Problems&);
    /// To the rows of the first table, which are of the entries drawn, in their order.
    void addTo(Results&) const;

  private:
    static constexpr std::size_t kNone = std::size_t(-1);
    struct Drawn {
        Image image;
        std::size_t baseline; ///< as counted here; kNone where it was not drawn
    };

    const BenchPlan& plan_;
    std::size_t contexts_;
    std::vector<Drawn> drawn_;
};

} // namespace gnomon
