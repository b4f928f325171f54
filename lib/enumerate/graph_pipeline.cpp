#include "enumerate/graph_pipeline.h"

#include "base/parallel.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

constexpr std::size_t batchSize = 128; ///< graphs

} // namespace

GraphPipeline::GraphPipeline(GraphStages stages, unsigned jobs) : stages_(std::move(stages)) {
    helpers_ = startThreads(std::max(jobs, 1U) - 1, [this] { work(); });
}

GraphPipeline::~GraphPipeline() {
    end(nullptr); // or the helpers would wait for ever
}

bool GraphPipeline::put(const Assignment& graph) {
    current_.graphs.push_back(graph);
    if (current_.graphs.size() == batchSize) submit();
    return wanted_;
}

bool GraphPipeline::finish() {
    if (!current_.graphs.empty()) submit();
    std::unique_lock lock(mutex_);
    while (!waiting_.empty() && !ended_)
        helpOut(lock);
    closing_ = true;
    changed_.notify_all();
    lock.unlock();
    helpers_.clear();
    if (failure_) std::rethrow_exception(failure_);
    return !ended_;
}

void GraphPipeline::submit() {
    Batch batch = std::exchange(current_, {current_.number + 1, {}});
    current_.graphs.reserve(batchSize);
    std::unique_lock lock(mutex_);
    waiting_.push_back(std::move(batch));
    changed_.notify_all();
    while (waiting_.size() > helpers_.size() && !ended_)
        helpOut(lock);
    wanted_ = !ended_;
}

void GraphPipeline::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return !waiting_.empty() || closing_ || ended_; });
        if (ended_ || waiting_.empty()) return;
        helpOut(lock);
    }
}

/// Processes the first waiting batch. Batches are taken in order, so all earlier ones are being processed.
void GraphPipeline::helpOut(std::unique_lock<std::mutex>& lock) {
    const Batch batch = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    try {
        process(batch);
    } catch (...) {
        end(std::current_exception());
    }
    lock.lock();
}

void GraphPipeline::process(const Batch& batch) {
    std::string text;
    for (const Assignment& graph : batch.graphs)
        stages_.append(graph, text);
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return taken_ == batch.number || ended_; });
        if (ended_) return;
    }
    if (!stages_.take(text, batch.graphs.size())) return end(nullptr);
    const std::lock_guard lock(mutex_);
    ++taken_;
    changed_.notify_all();
}

void GraphPipeline::end(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!ended_) failure_ = std::move(failure);
    ended_ = true;
    changed_.notify_all();
}

} // namespace qm
