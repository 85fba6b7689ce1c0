/// A library opened at run time: the program starts on machines that lack it, and says so only when it is asked for.
#pragma once

#include <dlfcn.h>

#include <initializer_list>

namespace gnomon {

class SharedLibrary {
  public:
    /// The first of `names` that opens. Never closed again: drivers leave threads and exit handlers behind.
    explicit SharedLibrary(std::initializer_list<const char*> names) {
        for (const char* name : names)
            if ((handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL))) return;
    }
    explicit operator bool() const { return handle_ != nullptr; }

    /// Sets `function` to the library's function of that name; false where it has none.
    template<class Function>
    bool get(Function*& function, const char* name) const {
        function = handle_ ? reinterpret_cast<Function*>(dlsym(handle_, name)) : nullptr;
        return function != nullptr;
    }

  private:
    void* handle_ = nullptr;
};

} // namespace gnomon
