#include "native/file/input_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gnomon {

namespace {

constexpr std::size_t kPiece = 1 << 16;

std::set<std::pair<dev_t, ino_t>> filesRead;

class Input {
  public:
    explicit Input(const std::string& file)
        : descriptor_(file == "-" ? STDIN_FILENO : open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {}
    ~Input() {
        if (descriptor_ > STDIN_FILENO) close(descriptor_);
    }
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    int get() const { return descriptor_; }

  private:
    int descriptor_;
};

/// Appends what comes next; the number of bytes, 0 at the end, less where it cannot be read.
ssize_t readPiece(int descriptor, std::string& bytes, std::size_t most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + std::min(kPiece, most));
    ssize_t count;
    do count = read(descriptor, bytes.data() + before, bytes.size() - before);
    while (count < 0 && errno == EINTR);
    bytes.resize(before + std::size_t(std::max<ssize_t>(count, 0)));
    return count;
}

} // namespace

bool wasRead(const std::string& file) {
    struct stat status {};
    return stat(file.c_str(), &status) == 0 && filesRead.contains({status.st_dev, status.st_ino});
}

std::string inputName(const std::string& file) { return file == "-" ? "standard input" : file; }

std::optional<std::string> readInput(const std::string& file, std::size_t most, const std::string& remedy,
                                     Problems& problems) {
    const auto refuse = [&](const std::string& what, const std::string& advice) {
        problems.push_back({inputName(file), 0, {}, what, advice});
        return std::nullopt;
    };
    const auto unreadable = [&] {
        return refuse(std::string("cannot be read: ") + std::strerror(errno),
                      "check that it exists and that you may read it");
    };
    const Input in(file);
    struct stat status {};
    if (in.get() < 0 || fstat(in.get(), &status) != 0) return unreadable();
    if (S_ISDIR(status.st_mode)) return refuse("is a folder", "name a file");
    if (S_ISBLK(status.st_mode) || (S_ISCHR(status.st_mode) && !isatty(in.get())))
        return refuse("is a device", "name a file");
    if (S_ISREG(status.st_mode)) filesRead.emplace(status.st_dev, status.st_ino);
    const std::string limit = "; at most " + std::to_string(most) + " are read";
    if (std::size_t(status.st_size) > most)
        return refuse("the file has " + std::to_string(status.st_size) + " bytes" + limit, remedy);
    std::string bytes;
    bytes.reserve(std::size_t(status.st_size) + 1);
    for (ssize_t count = 1; count > 0 && bytes.size() <= most;) {
        count = readPiece(in.get(), bytes, most + 1 - bytes.size());
        if (count < 0) return unreadable();
    }
    if (bytes.size() > most) return refuse("there are more than " + std::to_string(most) + " bytes" + limit, remedy);
    return bytes;
}

} // namespace gnomon
