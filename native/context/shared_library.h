/// A library opened at run time: the program starts on machines that lack it, and says so only when it is asked for.
#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <string>

namespace gnomon {

class SharedLibrary {
  public:
    /// The first of `names` that opens. Never closed again: drivers leave threads and exit handlers behind.
    explicit SharedLibrary(std::initializer_list<const char*> names) {
        for (const char* name : names) {
            if ((handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL))) return;
            const std::string reason = dlerror();
            if (reason.find("No such file") == std::string::npos && error_.empty()) error_ = reason;
        }
    }
    explicit operator bool() const { return handle_ != nullptr; }

    /// Sets `function` to the library's function of that name; false where it has none.
    template<class Function>
    bool get(Function*& function, const char* name) const {
        function = handle_ ? reinterpret_cast<Function*>(dlsym(handle_, name)) : nullptr;
        return function != nullptr;
    }

    /// Why it cannot be opened though it is installed; empty where it is not.
    const std::string& error() const { return error_; }

  private:
    std::string error_;
    void* handle_ = nullptr;
};

} // namespace gnomon
