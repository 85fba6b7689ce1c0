/// Bounding volume hierarchy: a binary tree of boxes, so that a ray asks only the primitives that it comes near.
///
/// build    splits by the surface area heuristic: over all splits of the sorted primitives where they are few, of 32
///          bins an axis where they are many. No recursion; the same boxes give the same tree everywhere
/// refit    new boxes for the same tree, from the last node to the first: what moving primitives need each frame
/// spoilt   by how much the tree has become worse than when it was built
/// Source   Goldsmith and Salmon 1987; Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007
///
/// A node is read in depth-first order: where a ray misses the box, or the node is a leaf, it goes on at `skip`, else
/// at the next node, which is the first child; the second is where the first one's skip leads. No stack is needed, and
/// a traversal that has one can still take the nearer child first. A box test in float32 does not lose a ray where its
/// entry is multiplied by 1 - 2^-21 and its exit by 1 + 2^-21: that is a subtraction, a reciprocal of 2.5 ulp and a
/// product (tests/unit/hierarchy_test.cpp).
#pragma once

#include "tracer/accel/bounds.h"

#include <span>
#include <vector>

namespace gnomon {

/// Most primitives of a leaf.
inline constexpr int kMaxLeaf = 8;

/// Texels (vec4) of a node: {low, skip}, {high, leaf}. `leaf` is -1 for an inner node, else kMaxLeaf * first + count -
/// 1: numbers that float32 holds exactly up to two million primitives.
inline constexpr int kNodeTexels = 2;

struct HierarchyNode {
    Bounds bounds;
    int skip = 0;             ///< the node after all below this one; the number of nodes where there is none
    int first = 0, count = 0; ///< a leaf's primitives in `order`; count is 0 for an inner node
};

struct Hierarchy {
    std::vector<HierarchyNode> nodes; ///< depth first, the root at 0; none where there are no primitives
    std::vector<int> order;           ///< the primitives, those of a leaf side by side
    double builtCost = 0;             ///< cost() when it was built

    /// What a ray that is aimed at the root's box anyhow has to expect, in box tests.
    double cost() const;
    /// cost() over what it was when built: 1 at first; where it exceeds 1.5 or so, building anew pays.
    double spoilt() const { return builtCost > 0 ? cost() / builtCost : 1; }
};

/// Boxes must be finite and not empty; `bounds[i]` is that of primitive i.
Hierarchy build(std::span<const Bounds> bounds);

/// As many boxes as it was built of.
void refit(Hierarchy&, std::span<const Bounds> bounds);

/// Appends all nodes as the shader reads them.
void appendTexels(const Hierarchy&, std::vector<glm::vec4>&);

} // namespace gnomon
