#include "tracer/scene/obj_file.h"

#include "tracer/problem.h"
#include "tracer/scene/text_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace gnomon {
namespace {

constexpr double kFarthest = 1e6; // as coordinates in scene files

class Reader {
  public:
    Reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    std::variant<ObjFile, Complaint> read() {
        text_ = withoutMark(text_);
        const bool plain = text_.substr(0, 64).find('\0') == std::string_view::npos; // as UTF-16 is not
        while (!text_.empty() && complaint_[0].empty()) {
            ++line_;
            readLine(continuedLine());
        }
        if (complaint_[0].empty() && obj_.faces.empty())
            complaint_ = {file_ + " has no faces", plain ? "use an OBJ file with lines that begin with f"
                                                         : "save it as plain text: it holds zero bytes"};
        if (!complaint_[0].empty()) return complaint_;
        return std::move(obj_);
    }

  private:
    /// A backslash at its end continues a line.
    std::string continuedLine() {
        std::string line;
        for (bool more = true; more && !text_.empty();) {
            std::string_view piece = nextLine(text_);
            while (!piece.empty() && isBlank(piece.back())) piece.remove_suffix(1);
            more = !piece.empty() && piece.back() == '\\';
            if (more) piece.remove_suffix(1);
            line += piece;
            line += more ? " " : "";
            if (more) ++line_;
        }
        return line.substr(0, line.find('#'));
    }

    void readLine(std::string_view line) {
        static constexpr std::array<std::string_view, 8> kFreeForm{"vp",     "curv", "curv2", "surf",
                                                                   "cstype", "deg",  "bmat",  "parm"};
        const std::string_view key = nextWord(line);
        if (key == "v") {
            glm::dvec3 v{0};
            if (numbers(line, &v.x, 3, 3, kFarthest)) obj_.positions.push_back(v);
        } else if (key == "vt") {
            glm::dvec2 uv{0};
            if (numbers(line, &uv.x, 1, 2, kFarthest)) obj_.uvs.push_back(uv);
        } else if (key == "vn") {
            readNormal(line);
        } else if (key == "f") {
            readFace(line);
        } else if (std::find(kFreeForm.begin(), kFreeForm.end(), key) != kFreeForm.end()) {
            refuse("a free-form curve or surface", "export the mesh as polygons");
        }
    }

    void readNormal(std::string_view line) {
        glm::dvec3 normal{0};
        if (!numbers(line, &normal.x, 3, 3, kFarthest)) return;
        const double length = glm::length(normal);
        obj_.normals.push_back(length > 0 ? normal / length : glm::dvec3(0)); // of none the face's stands
    }

    void readFace(std::string_view line) {
        const std::size_t first = obj_.corners.size();
        for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line))
            if (!readCorner(word)) return;
        const std::size_t count = obj_.corners.size() - first;
        if (count < 3) return refuse("a face of " + std::to_string(count) + " corners", "a face has three or more");
        if (count > 1000) return refuse("a face of " + std::to_string(count) + " corners", "use faces of at most 1000");
        obj_.faces.push_back({first, int(count)});
    }

    /// v, v/vt, v//vn or v/vt/vn.
    bool readCorner(std::string_view word) {
        std::array<std::string_view, 3> parts;
        std::size_t count = 0;
        for (std::string_view rest = word; count < 3; ++count) {
            const std::size_t slash = rest.find('/');
            parts[count] = rest.substr(0, slash);
            if (slash == std::string_view::npos) {
                ++count;
                break;
            }
            rest.remove_prefix(slash + 1);
            if (count == 2)
                return wrong("is no corner of a face: " + inQuotes(word), "write v, v/vt, v//vn or v/vt/vn");
        }
        ObjFile::Corner corner{-1, -1, -1};
        const bool right = index(parts[0], obj_.positions.size(), "vertex", corner.position) &&
                           (parts[1].empty() || index(parts[1], obj_.uvs.size(), "texture vertex", corner.uv)) &&
                           (parts[2].empty() || index(parts[2], obj_.normals.size(), "normal", corner.normal));
        if (right) obj_.corners.push_back(corner);
        return right;
    }

    /// From 1, or from the latest one, -1, backwards.
    bool index(std::string_view word, std::size_t known, const char* what, int& target) {
        int number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc{} || end != word.data() + word.size())
            return wrong(inQuotes(word) + " is no index", "write whole numbers");
        const long long from0 = number < 0 ? (long long)known + number : (long long)number - 1;
        if (number == 0 || from0 < 0 || from0 >= (long long)known)
            return wrong("a face names " + std::string(what) + " " + std::to_string(number) + ", of which " +
                             std::to_string(known) + " stand before it",
                         "count from 1, or from -1 backwards");
        target = int(from0);
        return true;
    }

    /// From `least` on as many as there are, at most `most`; what follows is left out: a weight, or colours.
    bool numbers(std::string_view line, double* target, int least, int most, double farthest) {
        for (int i = 0; i < most; ++i) {
            const std::string_view word = nextWord(line);
            if (word.empty() && i >= least) return true;
            if (word.empty())
                return wrong(std::to_string(i) + " numbers instead of " + std::to_string(least), "write all of them");
            if (!decimal(word, target[i]))
                return wrong(inQuotes(word) + " is no number", "write decimals with a point");
            if (!(std::abs(target[i]) <= farthest))
                return wrong(std::string(word) + " is outside the limits",
                             "keep numbers from " + toString(-farthest) + " to " + toString(farthest));
        }
        return true;
    }

    void refuse(const std::string& what, const std::string& remedy) { wrong(what, remedy); }
    bool wrong(const std::string& what, const std::string& remedy) {
        complaint_ = {file_ + ":" + std::to_string(line_) + ": " + what, remedy};
        return false;
    }

    std::string_view text_;
    std::string file_;
    int line_ = 0;
    ObjFile obj_;
    Complaint complaint_;
};

} // namespace

std::variant<ObjFile, Complaint> readObj(std::string_view text, const std::string& file) {
    return Reader(text, file).read();
}

} // namespace gnomon
