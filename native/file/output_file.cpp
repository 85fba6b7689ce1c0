#include "native/file/output_file.h"

#include "native/file/input_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gnomon {

namespace fs = std::filesystem;

namespace {

constexpr int kMostLinks = 40; ///< as the kernel follows
constexpr std::array kStandardOutput{"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};

int reservedOutput = -1; ///< standard output itself, where a result goes there

bool isStandardOutput(const std::string& file) {
    return std::find(kStandardOutput.begin(), kStandardOutput.end(), file) != kStandardOutput.end();
}

class File {
  public:
    explicit File(int descriptor) : descriptor_(descriptor) {}
    ~File() { close(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    explicit operator bool() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }
    /// Some file systems tell only here that there was no room.
    bool close() { return descriptor_ < 0 || ::close(std::exchange(descriptor_, -1)) == 0; }

  private:
    int descriptor_;
};

/// An interruption waits until a draft is renamed or removed.
class NoInterruption {
  public:
    NoInterruption() {
        sigset_t signals;
        sigemptyset(&signals);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
        pthread_sigmask(SIG_BLOCK, &signals, &before_);
    }
    ~NoInterruption() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    NoInterruption(const NoInterruption&) = delete;
    NoInterruption& operator=(const NoInterruption&) = delete;

  private:
    sigset_t before_;
};

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(std::size_t(written));
    }
    return true;
}

/// The file that a chain of links leads to, whether it exists or not.
fs::path followed(fs::path path) {
    std::error_code none;
    for (int i = 0; i < kMostLinks && fs::is_symlink(path, none); ++i) {
        const fs::path target = fs::read_symlink(path, none);
        path = target.is_absolute() ? target : path.parent_path() / target;
    }
    return path;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

/// A new file beside the one that it will replace, with a name that is short whatever the other is called.
std::pair<fs::path, int> makeDraft(const fs::path& file) {
    for (int i = 0; i < 100; ++i) {
        fs::path draft = folderOf(file) / (".gnomon-" + std::to_string(getpid()) + "-" + std::to_string(i) + ".part");
        const int descriptor = open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        // Moved: a copy takes memory, and where there is none the draft would stay.
        if (descriptor >= 0 || errno != EEXIST) return {std::move(draft), descriptor};
    }
    return {{}, -1};
}

/// What a draft has to take over from the file that it replaces.
bool takeOver(int draft, const struct stat& old) {
    struct stat made {};
    if (fstat(draft, &made) != 0) return false;
    const bool same = made.st_uid == old.st_uid && made.st_gid == old.st_gid;
    return (same || fchown(draft, old.st_uid, old.st_gid) == 0) && fchmod(draft, old.st_mode & 07777) == 0;
}

/// Nothing where no draft can be made that is like the old file.
std::optional<bool> writeByDraft(const fs::path& file, const struct stat* old, std::string_view bytes) {
    const NoInterruption whole;
    const auto [draft, descriptor] = makeDraft(file);
    if (descriptor < 0) return std::nullopt;
    File out(descriptor);
    std::optional<bool> done;
    if (!old || takeOver(out.get(), *old)) {
        done = writeAll(out.get(), bytes) && fsync(out.get()) == 0;
        done = out.close() && *done;
        if (*done) done = rename(draft.c_str(), file.c_str()) == 0;
    }
    const int reason = errno;
    if (!done.value_or(false)) unlink(draft.c_str());
    errno = reason;
    return done;
}

/// The old bytes stay until there is room for all new ones.
bool overwrite(const fs::path& file, std::string_view bytes) {
    const NoInterruption whole;
    File out(open(file.c_str(), O_WRONLY | O_CLOEXEC));
    struct stat old {};
    if (!out || fstat(out.get(), &old) != 0) return false;
    const off_t size = off_t(bytes.size());
    if (const int error = size > 0 ? posix_fallocate(out.get(), 0, size) : 0; error != 0) {
        if (ftruncate(out.get(), old.st_size) != 0) return false;
        errno = error;
        return false;
    }
    return writeAll(out.get(), bytes) && ftruncate(out.get(), size) == 0 && fsync(out.get()) == 0 && out.close();
}

bool writeStream(const fs::path& file, std::string_view bytes) {
    File out(open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    return out && writeAll(out.get(), bytes) && out.close();
}

bool writeTo(const std::string& file, std::string_view bytes) {
    if (isStandardOutput(file)) return writeAll(reservedOutput, bytes);
    struct stat old {};
    const bool exists = stat(file.c_str(), &old) == 0;
    if (exists && !S_ISREG(old.st_mode)) return writeStream(file, bytes);
    const fs::path target = followed(file);
    if (!exists || old.st_nlink == 1)
        if (const auto done = writeByDraft(target, exists ? &old : nullptr, bytes)) return *done;
    return exists && overwrite(target, bytes);
}

std::string inWords(const std::string& file) { return isStandardOutput(file) ? "standard output" : file; }

} // namespace

bool prepareOutput(const std::string& file, Problems& problems) {
    const auto refuse = [&](const std::string& what, const char* remedy) {
        problems.push_back({inWords(file), 0, {}, what, remedy});
        return false;
    };
    if (isStandardOutput(file)) {
        if (reservedOutput >= 0) return refuse("takes one result only", "write the other one to a file");
        std::fflush(stdout);
        reservedOutput = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
        return reservedOutput >= 0 && dup2(STDERR_FILENO, STDOUT_FILENO) >= 0
                   ? true
                   : refuse(std::string("cannot be written: ") + std::strerror(errno), "leave it open");
    }
    struct stat old {};
    const fs::path folder = folderOf(followed(file));
    std::error_code none;
    if (stat(file.c_str(), &old) == 0) {
        if (S_ISDIR(old.st_mode)) return refuse("is a folder", "name a file");
        if (S_ISBLK(old.st_mode)) return refuse("is a device", "name a file");
        if (access(file.c_str(), W_OK) == 0) return true;
    } else if (errno == ENOENT || errno == ENOTDIR) {
        if (!fs::is_directory(folder, none)) return refuse("there is no folder " + folder.string(), "make it first");
        if (access(folder.c_str(), W_OK | X_OK) == 0) return true;
    }
    return refuse(std::string("cannot be written: ") + std::strerror(errno), "check the name and its permissions");
}

bool sparesInputs(const std::string& file, Problems& problems) {
    if (file.empty() || !wasRead(file)) return true;
    problems.push_back({file, 0, {}, "has been read here, and would be lost", "write to another file"});
    return false;
}

bool writeOutput(const std::string& file, std::string_view bytes, Problems& problems) {
    if (!sparesInputs(file, problems)) return false;
    if (writeTo(file, bytes)) return true;
    problems.push_back({inWords(file),
                        0,
                        {},
                        std::string("cannot be written: ") + std::strerror(errno),
                        "check the folder, its permissions and the free space"});
    return false;
}

bool isStream(const std::string& file) {
    struct stat old {};
    return isStandardOutput(file) || (stat(file.c_str(), &old) == 0 && !S_ISREG(old.st_mode) && !S_ISDIR(old.st_mode));
}

} // namespace gnomon
