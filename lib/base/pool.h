/// \file Objects that are costly to make, for use by one thread at a time.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace qm {

/// Makes no more objects than threads use at the same time.
template <class T> class Pool {
public:
    explicit Pool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

    /// Calls f with an object that no other thread uses meanwhile. Which one is left to chance, so a result
    /// must not depend on what earlier calls did to it.
    template <class Function> auto use(const Function& f) {
        std::unique_ptr<T> object = take();
        const auto giveBack = [this](T* used) {
            const std::lock_guard<std::mutex> lock(mutex_);
            idle_.emplace_back(used);
        };
        const std::unique_ptr<T, decltype(giveBack)> used(object.release(), giveBack);
        return f(*used);
    }

private:
    std::unique_ptr<T> take() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!idle_.empty()) {
                std::unique_ptr<T> object = std::move(idle_.back());
                idle_.pop_back();
                return object;
            }
        }
        return make_();
    }

    std::function<std::unique_ptr<T>()> make_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> idle_;
};

} // namespace qm
