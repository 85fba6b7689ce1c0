#include "tracer/scene/bpt_file.h"

#include "tracer/problem.h"
#include "tracer/scene/read_patch.h"
#include "tracer/scene/scene_format.h"
#include "tracer/scene/text_words.h"

#include <cmath>

namespace gnomon {
namespace {

constexpr double kFarthest = 1e6; // as coordinates in scene files

class Reader {
  public:
    Reader(std::string_view text, const std::string& file, std::size_t most)
        : text_(withoutMark(text)), file_(file), most_(most) {}

    std::variant<std::vector<Shape>, Complaint> read() {
        std::size_t count = 0;
        bool right = readCount(count);
        std::vector<ControlPoints> patches;
        for (std::size_t i = 0; right && i < count; ++i) right = readPatch(i, count, patches.emplace_back());
        if (right && nextWords() > 0)
            right = wrong("a line after the last of " + std::to_string(count) + " patches",
                          "let the first line tell how many there are");
        if (!right) return complaint_;
        return shapesOf(patches);
    }

  private:
    /// Of the next line that is not blank; 0 where the file ends.
    int nextWords() {
        while (!text_.empty()) {
            ++line_;
            std::string_view line = nextLine(text_);
            int count = 0;
            for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line), ++count)
                if (count < 5) words_[count] = word;
            if (count > 0) return count;
        }
        return 0;
    }

    bool readCount(std::size_t& count) {
        const int words = nextWords();
        double number = 0;
        if (words == 0) return wrong("is empty", "begin with the number of patches");
        if (words > 1 || !decimal(words_[0], number) || number != std::floor(number) || number < 1)
            return wrong("begins with no number of patches", "write how many there are on a line of its own");
        if (number > double(most_))
            return wrong(std::string(words_[0]) + " patches; a scene has at most " + std::to_string(most_) + " objects",
                         "use a model of fewer patches");
        count = std::size_t(number);
        return true;
    }

    bool readPatch(std::size_t index, std::size_t count, ControlPoints& points) {
        const int words = nextWords();
        if (words == 0) return ends(index, count);
        double u = 0, v = 0;
        if (words != 2 || !decimal(words_[0], u) || !decimal(words_[1], v))
            return wrong("a patch does not begin with its degrees", "write 3 3, then its 16 points");
        if (u != 3 || v != 3)
            return wrong("a patch of degrees " + toString(u) + " and " + toString(v), "raise its degrees to 3 and 3");
        int numbers = 0; // of each of its points
        for (glm::dvec4& point : points) {
            const int found = nextWords();
            if (found == 0) return ends(index, count);
            if (numbers == 0) numbers = found;
            if (!readPoint(found, numbers, point)) return false;
        }
        return true;
    }

    bool readPoint(int found, int wanted, glm::dvec4& point) {
        if (found != 3 && found != 4)
            return wrong("a point of " + std::to_string(found) + " numbers", "write x, y and z, or these and a weight");
        if (found != wanted)
            return wrong("a point " + std::string(found == 4 ? "with" : "without") +
                             " a weight, unlike those before it",
                         "give all points of a patch weights, or none");
        point.w = 1;
        for (int i = 0; i < found; ++i) {
            if (!decimal(words_[i], point[i]))
                return wrong(inQuotes(words_[i]) + " is no number", "write decimals with a point");
            if (i < 3 && !(std::abs(point[i]) <= kFarthest))
                return wrong(std::string(words_[i]) + " is outside the limits",
                             "keep numbers from " + toString(-kFarthest) + " to " + toString(kFarthest));
        }
        if (point.w >= kWeight.min && point.w <= kWeight.max) return true;
        return wrong("a weight of " + toString(point.w),
                     "keep weights from " + toString(kWeight.min) + " to " + toString(kWeight.max));
    }

    /// About one anchor: what neighbours share stays shared.
    std::variant<std::vector<Shape>, Complaint> shapesOf(const std::vector<ControlPoints>& patches) const {
        glm::dvec3 low(patches[0][0]), high = low;
        for (const ControlPoints& points : patches)
            for (const glm::dvec4& p : points) low = glm::min(low, glm::dvec3(p)), high = glm::max(high, glm::dvec3(p));
        std::vector<Shape> shapes;
        shapes.reserve(patches.size());
        for (const ControlPoints& points : patches) {
            const Shape& shape = shapes.emplace_back(spacePatch(points, 0.5 * (low + high)));
            if (const auto [what, remedy] = shapeRow(shape.kind).check(shape); !what.empty())
                return Complaint{file_ + ": patch " + std::to_string(shapes.size()) + ": " + what, remedy};
        }
        return shapes;
    }

    bool ends(std::size_t index, std::size_t count) {
        return wrong("ends within patch " + std::to_string(index + 1) + " of " + std::to_string(count),
                     "let the first line tell how many there are, each of 16 points");
    }
    bool wrong(const std::string& what, const std::string& remedy) {
        complaint_ = {file_ + ":" + std::to_string(line_) + ": " + what, remedy};
        return false;
    }

    std::string_view text_;
    std::string file_;
    std::size_t most_;
    int line_ = 0;
    std::string_view words_[5];
    Complaint complaint_;
};

} // namespace

std::variant<std::vector<Shape>, Complaint> patchesOf(std::string_view text, const std::string& file,
                                                      std::size_t most) {
    return Reader(text, file, most).read();
}

} // namespace gnomon
