/// Bounding volume hierarchy: a binary tree of boxes, so that a ray asks only the primitives that it comes near.
///
/// build    splits by the surface area heuristic: over all splits of the sorted primitives where they are few, of 32
///          bins an axis where they are many. No recursion; the same boxes give the same tree everywhere
/// refit    new boxes for the same tree, from the last node to the first: what moving primitives need each frame
/// spoilt   by how much the tree has become worse than when it was built
/// Source   Goldsmith and Salmon 1987; Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007
///
/// A leaf holds one primitive, so that n of them always make 2n - 1 nodes: a tree built anew fits where the old one
/// was. Nodes lie depth first: where a ray misses the box, or the node is a leaf, it goes on at `skip`, else at the
/// next node, which is the first child; the second is where the first one's skip leads. No stack is needed.
#pragma once

#include "tracer/accel/bounds.h"

#include <span>
#include <vector>

namespace gnomon {

struct HierarchyNode {
    Bounds bounds;
    int skip = 0;       ///< the node after all below this one; the number of nodes where there is none
    int primitive = -1; ///< of a leaf; -1: an inner node

    bool isLeaf() const { return primitive >= 0; }
};

struct Hierarchy {
    std::vector<HierarchyNode> nodes; ///< depth first, the root at 0; none where there are no primitives
    double builtCost = 0;             ///< cost() when it was built

    /// Boxes that a ray which is aimed at the root's box has to ask, on average: each child of a box that it meets.
    double cost() const;
    /// Primitives that such a ray has to ask.
    double primitivesAsked() const;
    /// cost() over what it was when built: 1 at first; where it exceeds 1.5 or so, building anew pays.
    double spoilt() const { return builtCost > 0 ? cost() / builtCost : 1; }
};

inline int nodesFor(int primitives) { return primitives > 0 ? 2 * primitives - 1 : 0; }

/// Boxes must be finite and not empty; `bounds[i]` is that of primitive i.
Hierarchy build(std::span<const Bounds> bounds);

/// As many boxes as it was built of.
void refit(Hierarchy&, std::span<const Bounds> bounds);

/// Fits the hierarchy to the boxes as they are now, in whatever way is best: as it is, refitted, or built anew.
void update(Hierarchy&, std::span<const Bounds> bounds);

} // namespace gnomon
