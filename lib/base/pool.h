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
        const Loan loan(*this);
        return f(*loan.object);
    }

private:
    struct Loan {
        explicit Loan(Pool& from) : pool(from), object(from.take()) {}
        ~Loan() {
            const std::lock_guard<std::mutex> lock(pool.mutex_);
            pool.idle_.push_back(object); // there is room, so it cannot fail
        }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        Pool& pool;
        T* object;
    };

    T* take() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!idle_.empty()) {
                T* object = idle_.back();
                idle_.pop_back();
                return object;
            }
        }
        std::unique_ptr<T> made = make_();
        const std::lock_guard<std::mutex> lock(mutex_);
        idle_.reserve(all_.size() + 1);
        all_.push_back(std::move(made));
        return all_.back().get();
    }

    std::function<std::unique_ptr<T>()> make_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> all_;
    std::vector<T*> idle_;
};

} // namespace qm
