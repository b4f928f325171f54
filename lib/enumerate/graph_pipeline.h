/// \file Turning found graphs into a stream of text: one thread finds graphs, several write their text, and
/// the caller receives the text in the order in which graphs were found.
#pragma once

#include "enumerate/state/assignment.h"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace qm {

/// The work of the pipeline.
struct GraphStages {
    /// Appends the text of a graph; called on several threads at the same time.
    std::function<void(const Assignment& graph, std::string& text)> append;
    /// Receives the text of the next graphs. Calls come from different threads, but one after the other.
    /// Returns false if no more is wanted.
    std::function<bool(std::string_view text, std::size_t graphs)> take;
};

/// Holds at most a few batches of graphs per thread, however many graphs there are.
class GraphPipeline {
public:
    /// \param jobs  largest number of threads, including the one that finds graphs
    GraphPipeline(GraphStages stages, unsigned jobs);
    ~GraphPipeline();
    GraphPipeline(const GraphPipeline&) = delete;
    GraphPipeline& operator=(const GraphPipeline&) = delete;

    /// To be called by the finding thread, which writes texts itself when the other threads fall behind.
    /// \return false if no more graphs are wanted
    bool put(const Assignment& graph);

    /// Waits until all graphs have been taken.
    /// \return false if some were not wanted
    /// \throw whatever a stage threw
    bool finish();

private:
    struct Batch {
        std::size_t number = 0;
        std::vector<Assignment> graphs;
    };

    void submit();
    void work();
    void helpOut(std::unique_lock<std::mutex>& lock);
    void process(const Batch& batch);
    void end(std::exception_ptr failure);

    GraphStages stages_;
    Batch current_;
    bool wanted_ = true; ///< the finding thread's copy of `!ended_`
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Batch> waiting_;
    std::size_t taken_ = 0; ///< batches taken so far
    bool closing_ = false;
    bool ended_ = false; ///< no more graphs are wanted
    std::exception_ptr failure_;
    std::vector<std::jthread> helpers_;
};

} // namespace qm
