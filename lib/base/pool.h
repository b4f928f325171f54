/// \file Objects that are costly to make, for use by one thread at a time.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

namespace qm {

/// Makes no more objects than threads use at the same time.
template <class T> class Pool {
public:
    explicit Pool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

    /// Calls f with an object that no other thread uses meanwhile. Which one is left to chance, so a result
    /// must not depend on what earlier calls did to it.
    template <class Function> auto use(const Function& f) {
        const Loan loan(*this);
        return f(*loan.one.front());
    }

private:
    /// An object on its way: nodes go from list to list, which cannot fail.
    struct Loan {
        explicit Loan(Pool& from) : pool(from) {
            {
                const std::lock_guard<std::mutex> lock(pool.mutex_);
                if (!pool.idle_.empty()) one.splice(one.begin(), pool.idle_, pool.idle_.begin());
            }
            if (one.empty()) one.push_back(pool.make_());
        }
        ~Loan() {
            const std::lock_guard<std::mutex> lock(pool.mutex_);
            pool.idle_.splice(pool.idle_.begin(), one);
        }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        Pool& pool;
        std::list<std::unique_ptr<T>> one;
    };

    std::function<std::unique_ptr<T>()> make_;
    std::mutex mutex_;
    std::list<std::unique_ptr<T>> idle_;
};

} // namespace qm
