/// The measurements of `gnomon lab intersect`: the shader's intersectors beside the textbook's, for every shape, class
/// of rays and distance.
#pragma once

#include "lab/intersect/compare_hit.h"
#include "lab/intersect/subjects.h"
#include "lab/results/quartiles.h"
#include "lab/results/results.h"
#include "tracer/shader/library.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gnomon::oracle {

struct IntersectCell {
    Subject subject;
    std::optional<RayClass> kind; ///< none: shared edges, through a fan of triangles (lab/reference/exact/fan.h)
    double distance;              ///< in sizes
};
std::string_view raysOf(const IntersectCell&);

/// All that fit of the given shapes (empty: all) at the distances. Cells of one placed shape follow each other.
std::vector<IntersectCell> intersectCells(const std::vector<std::string>& shapes, const std::vector<double>& distances);

struct IntersectRow {
    IntersectCell cell;
    Tally ours, textbook;
    Quartiles cost; ///< ours to textbook, over interleaved pairs
};

class IntersectLab {
  public:
    /// `textbook` are the textbook's files, taking the place of the library's. `clock` counts the seconds of a cost.
    IntersectLab(std::span<const ShaderFile> textbook, double (*clock)());
    ~IntersectLab();

    /// Measures one cell with so many rays in the current context. False, with problems, where it cannot.
    bool measure(const IntersectCell&, int rays, IntersectRow&, Problems&);

  private:
    struct Pair;
    bool prepare(const std::vector<Shape>&, Problems&);
    std::span<const ShaderFile> textbook_;
    double (*clock_)();
    std::unique_ptr<Pair> pair_; ///< compiled for the last placed shape
};

/// One row a shape, over all classes and distances: what docs/numerics.md shows.
Table intersectSummary(const std::vector<IntersectRow>&);
/// Every row, and charts to go with it.
Table intersectTable(const std::vector<IntersectRow>&);
std::vector<Chart> intersectCharts();

} // namespace gnomon::oracle
