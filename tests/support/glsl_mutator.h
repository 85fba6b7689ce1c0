/// Shader source written anew so that it computes the same: each result is the result of the same IEEE operations.
///
/// The compiler sees other code: conditions that hold always but are not known to (no canvas is of negative size), dead
/// code behind those that never hold, operands the other way round, copies, loops that run once or whose first
/// iteration stands before them. Nothing is reassociated, distributed or contracted.
///
/// Source  A. Donaldson et al., Automated Testing of Graphics Shader Compilers, 2017 (GraphicsFuzz)
/// Limits  the GLSL that the shader builder writes: no comments, macros or switch. Left as they are: constants,
///         structs, shaders without a frame block
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gnomon::test {

/// What is rewritten, a bit each.
enum Mutation : unsigned {
    kOperands = 1,    ///< a + b, a * b, a < b the other way round
    kChoices = 2,     ///< c ? a : b as !c ? b : a or by if and else; if (c) a else b as if (!c) b else a; a && b by ||
    kConditions = 4,  ///< statements, blocks and first values under a condition that holds always
    kDeadCode = 8,    ///< break, continue, return and discard under one that never holds
    kCopies = 16,     ///< x = e by another variable, x += e as x = x + e
    kIdentities = 32, ///< e as e * 1 or as one ? e : 0
    kLoops = 64,      ///< a statement in a loop that runs once, a first iteration before its loop, do-while as for
    kAllMutations = 127,
};

struct Mutations {
    std::uint64_t seed = 1;
    unsigned kinds = kAllMutations;
    double probability = 0.25; ///< of each place that could be rewritten
    /// Each operation on floats behind an optimisation barrier, so that no compiler puts any two of them together.
    bool barriers = false;
};

/// The same text for the same mutations.
std::string mutated(std::string_view glsl, const Mutations&);

} // namespace gnomon::test
