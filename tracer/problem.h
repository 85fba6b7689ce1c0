/// What is wrong with something a user gave us: where it stands, what is wrong, what to do.
///
/// Nothing in tracer/ throws or prints. Functions that can fail take a `Problems&` and add to it; the host decides how
/// to show them and which exit code they mean. All problems of one input are found in one pass.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

struct Problem {
    std::string file;   ///< file or command-line place the problem stands in; may be empty
    int line = 0;       ///< 1-based line in `file`, 0 where there is none
    std::string path;   ///< place inside the document, as `objects[12].torus`; may be empty
    std::string what;   ///< what is wrong
    std::string remedy; ///< what to do about it; may be empty
};

using Problems = std::vector<Problem>;

/// No list of problems that is shown is longer: a screen holds them.
inline constexpr std::size_t kMostProblems = 20;

/// The first ones, and of longer lists how many more there are.
Problems screenful(Problems);

/// Takes the problems of one input. A screenful is kept, the others are counted: a flood costs neither memory nor
/// patience.
class ProblemCounter {
  public:
    ProblemCounter(std::string file, Problems& kept);
    ~ProblemCounter(); ///< adds how many more there were
    ProblemCounter(const ProblemCounter&) = delete;
    ProblemCounter& operator=(const ProblemCounter&) = delete;

    const std::string& file() const { return file_; }
    void add(int line, std::string path, std::string what, std::string remedy = {});
    /// The next one will be kept: else nobody needs to put it in words.
    bool keeps() const { return count_ + 1 < kMostProblems; }
    void countOne() { ++count_; }
    /// All that there were.
    std::size_t count() const { return count_; }

  private:
    std::string file_;
    Problems& kept_;
    std::size_t count_ = 0;
};

/// One line, `FILE:LINE: PATH: what; remedy`, empty parts left out.
std::string toString(const Problem&);

/// A screenful, one a line.
std::string toString(const Problems&);

/// The candidate closest to `word` by edit distance (letters, swapped neighbours; case does not count), or empty where
/// none is close enough to be meant. Of equally close ones the first.
std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates);

/// A number as a message shows it: up to ten digits, no trailing zeros.
std::string toString(double);

/// `text` in double quotes, as a message shows it: control characters replaced, long text cut.
std::string inQuotes(std::string_view text);

} // namespace gnomon
