#include "tracer/software/screen_partition.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kTile = 8;      // pixels
constexpr double kMargin = 1; // pixels about a rectangle

enum class Shows : unsigned char { Sky, Base, Uncommon };

/// The box about an object, seen from the eye along the world's axes, and the ball within which it lies in that.
struct BoundedObject {
    glm::dvec3 middle, half;
    double radius;
    bool uncommon;
};

/// Sorts the tiles of a picture by what they may show.
class Sorter {
  public:
    Sorter(std::span<const ScreenBounds> sights, const CameraFrame& camera, int width, int height)
        : camera_(camera), width_(width), height_(height), columns_((width + kTile - 1) / kTile),
          rows_((height + kTile - 1) / kTile), shows_(std::size_t(columns_) * rows_, Shows::Sky) {
        for (const ScreenBounds& bounds : sights) {
            if (!bounds.bounds) {
                everywhere_ = std::max(everywhere_, bounds.uncommon ? Shows::Uncommon : Shows::Base);
                continue;
            }
            const glm::dvec3 low(bounds.bounds->low), high(bounds.bounds->high), half = 0.5 * (high - low);
            objects_.push_back({0.5 * (low + high) - camera.eye, half,
                                bounds.round ? std::max({half.x, half.y, half.z}) : glm::length(half),
                                bounds.uncommon});
        }
    }

    void sort() {
        std::vector<int> all;
        for (std::size_t i = 0; i < objects_.size(); ++i) all.push_back(int(i));
        sort({0, 0, columns_, rows_}, all);
    }

    /// As few rectangles as rows of equal runs make.
    std::vector<Rectangle> gather(Shows what) const {
        std::vector<Rectangle> done, open; // in tiles; those of the row below
        for (int y = 0; y < rows_; ++y) {
            std::vector<Rectangle> row;
            for (const Rectangle& run : runs(what, y)) {
                const auto below = std::find_if(
                    open.begin(), open.end(), [&](const Rectangle& o) { return o.x == run.x && o.width == run.width; });
                row.push_back(run);
                if (below == open.end()) continue;
                row.back() = {below->x, below->y, below->width, below->height + 1};
                open.erase(below);
            }
            done.insert(done.end(), open.begin(), open.end());
            open = std::move(row);
        }
        done.insert(done.end(), open.begin(), open.end());
        for (Rectangle& r : done) r = pixels(r);
        return done;
    }

  private:
    /// Settles the tiles of `part`, in which only `candidates` may be seen.
    void sort(const Rectangle& part, const std::vector<int>& candidates) {
        std::vector<int> seen;
        const auto planes = planesOf(pixels(part));
        for (const int i : candidates)
            if (mayShow(planes, objects_[std::size_t(i)])) seen.push_back(i);
        const bool uncommon = everywhere_ == Shows::Uncommon || std::any_of(seen.begin(), seen.end(), [&](int i) {
                                  return objects_[std::size_t(i)].uncommon;
                              });
        if (seen.empty() || (part.width == 1 && part.height == 1)) {
            const Shows shows = uncommon ? Shows::Uncommon : seen.empty() ? everywhere_ : Shows::Base;
            for (int y = part.y; y < part.y + part.height; ++y)
                std::fill_n(shows_.begin() + std::ptrdiff_t(y) * columns_ + part.x, part.width, shows);
            return;
        }
        const int left = (part.width + 1) / 2, lower = (part.height + 1) / 2;
        for (const int x : {0, left})
            for (const int y : {0, lower}) {
                const Rectangle quarter{part.x + x, part.y + y, x ? part.width - left : left,
                                        y ? part.height - lower : lower};
                if (quarter.width > 0 && quarter.height > 0) sort(quarter, seen);
            }
    }

    Rectangle pixels(const Rectangle& tiles) const {
        const int x = tiles.x * kTile, y = tiles.y * kTile;
        return {x, y, std::min(tiles.width * kTile, width_ - x), std::min(tiles.height * kTile, height_ - y)};
    }

    /// Normals of the planes through the eye within which rays of a rectangle go, the last one across the view.
    std::array<glm::dvec3, 5> planesOf(const Rectangle& r) const {
        const auto slope = [](double at, int size) { return 2 * at / size - 1; };
        const double up = camera_.halfHeight, across = up * width_ / height_;
        const double x0 = across * slope(r.x - kMargin, width_), x1 = across * slope(r.x + r.width + kMargin, width_);
        const double y0 = up * slope(r.y - kMargin, height_), y1 = up * slope(r.y + r.height + kMargin, height_);
        return {camera_.right - x0 * camera_.forward, x1 * camera_.forward - camera_.right,
                camera_.up - y0 * camera_.forward, y1 * camera_.forward - camera_.up, camera_.forward};
    }

    /// No plane has all of the object behind it.
    static bool mayShow(const std::array<glm::dvec3, 5>& planes, const BoundedObject& object) {
        return std::all_of(planes.begin(), planes.end(), [&](glm::dvec3 normal) {
            const double reach = std::min(glm::dot(glm::abs(normal), object.half), object.radius * glm::length(normal));
            return glm::dot(normal, object.middle) + reach >= 0;
        });
    }

    std::vector<Rectangle> runs(Shows what, int y) const {
        std::vector<Rectangle> found;
        for (int x = 0; x < columns_; ++x) {
            if (shows_[std::size_t(y) * columns_ + x] != what) continue;
            if (!found.empty() && found.back().x + found.back().width == x)
                ++found.back().width;
            else
                found.push_back({x, y, 1, 1});
        }
        return found;
    }

    CameraFrame camera_;
    int width_, height_, columns_, rows_;
    std::vector<BoundedObject> objects_;
    Shows everywhere_ = Shows::Sky;
    std::vector<Shows> shows_;
};

} // namespace

ScreenPartition partitionOf(std::span<const ScreenBounds> sights, const CameraFrame& camera, int width, int height) {
    Sorter sorter(sights, camera, width, height);
    sorter.sort();
    return {sorter.gather(Shows::Sky), sorter.gather(Shows::Base), sorter.gather(Shows::Uncommon)};
}

} // namespace gnomon
