/// Preloaded into the program (LD_PRELOAD), makes one thing fail that may fail at any time.
///
/// GNOMON_FAIL_ALLOCATION=N  the N-th operator new that the program itself or libstdc++ asks for throws std::bad_alloc;
///                           a driver's own allocations are not ours to watch
/// GNOMON_FAIL_CALL=N        the N-th of the calls that open, write, sync, close or rename a file for writing fails
///                           with ENOSPC or EIO
/// GNOMON_FAULTS_SEEN=FILE   at its end the program writes how many of either there were
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

namespace {

std::atomic<long> allocations{0}, calls{0};

long wanted(const char* name) {
    const char* text = std::getenv(name);
    return text ? std::atol(text) : 0;
}
const long failAllocation = wanted("GNOMON_FAIL_ALLOCATION"), failCall = wanted("GNOMON_FAIL_CALL");

struct Range {
    std::uintptr_t from = 0, to = 0;
};
Range ours[2]; ///< the program's code and libstdc++'s

int noteObject(dl_phdr_info* info, std::size_t, void* index) {
    int& i = *static_cast<int*>(index);
    const bool program = i++ == 0, library = std::strstr(info->dlpi_name, "libstdc++") != nullptr;
    for (int p = 0; (program || library) && p < info->dlpi_phnum; ++p)
        if (info->dlpi_phdr[p].p_type == PT_LOAD && (info->dlpi_phdr[p].p_flags & PF_X) != 0) {
            const std::uintptr_t from = info->dlpi_addr + info->dlpi_phdr[p].p_vaddr;
            ours[program ? 0 : 1] = {from, from + info->dlpi_phdr[p].p_memsz};
        }
    return 0;
}

bool isOurs(const void* caller) {
    const auto at = reinterpret_cast<std::uintptr_t>(caller);
    for (const Range& range : ours)
        if (at >= range.from && at < range.to) return true;
    return false;
}

void* allocate(std::size_t size, const void* caller) {
    if (isOurs(caller)) {
        if (++allocations == failAllocation) throw std::bad_alloc();
    }
    if (void* block = std::malloc(size ? size : 1)) return block;
    throw std::bad_alloc();
}

/// Is this the call that fails?
bool fails(int error) {
    if (++calls != failCall) return false;
    errno = error;
    return true;
}

template<typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool isFile(int descriptor) { return descriptor > STDERR_FILENO; }

__attribute__((constructor)) void begin() {
    int index = 0;
    dl_iterate_phdr(noteObject, &index);
}

__attribute__((destructor)) void end() {
    const char* file = std::getenv("GNOMON_FAULTS_SEEN");
    if (!file) return;
    const long seen[] = {allocations, calls};
    if (FILE* out = std::fopen(file, "w")) {
        std::fprintf(out, "%ld %ld\n", seen[0], seen[1]);
        std::fclose(out);
    }
}

} // namespace

void* operator new(std::size_t size) { return allocate(size, __builtin_return_address(0)); }
void* operator new[](std::size_t size) { return allocate(size, __builtin_return_address(0)); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }

extern "C" {

int open(const char* file, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = va_arg(arguments, mode_t);
    va_end(arguments);
    if ((flags & O_ACCMODE) != O_RDONLY && fails(ENOSPC)) return -1;
    return next<int (*)(const char*, int, mode_t)>("open")(file, flags, mode);
}
ssize_t write(int descriptor, const void* bytes, std::size_t size) {
    if (isFile(descriptor) && fails(ENOSPC)) return -1;
    return next<ssize_t (*)(int, const void*, std::size_t)>("write")(descriptor, bytes, size);
}
int fsync(int descriptor) { return fails(EIO) ? -1 : next<int (*)(int)>("fsync")(descriptor); }
int rename(const char* from, const char* to) {
    return fails(ENOSPC) ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}
int fchmod(int descriptor, mode_t mode) {
    return fails(EIO) ? -1 : next<int (*)(int, mode_t)>("fchmod")(descriptor, mode);
}
int posix_fallocate(int descriptor, off_t from, off_t size) {
    return fails(ENOSPC) ? ENOSPC : next<int (*)(int, off_t, off_t)>("posix_fallocate")(descriptor, from, size);
}
}
