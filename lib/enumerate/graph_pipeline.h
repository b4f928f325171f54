/// \file From found graphs to a stream of text: one thread finds, several write, and the caller gets the text
/// in the order of finding.
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

/// What becomes of graphs.
struct GraphStages {
    /// Appends what is to be said of a graph; called on several threads.
    std::function<void(const Assignment& graph, std::string& text)> append;
    /// Takes the text of some graphs; never twice at the same time, but on any thread. False: no more of
    /// them.
    std::function<bool(std::string_view text, std::size_t graphs)> take;
};

/// Holds a few batches of graphs for each thread, whatever their number.
class GraphPipeline {
public:
    /// \param jobs  threads at most, the finding one among them
    GraphPipeline(GraphStages stages, unsigned jobs);
    ~GraphPipeline();
    GraphPipeline(const GraphPipeline&) = delete;
    GraphPipeline& operator=(const GraphPipeline&) = delete;

    /// Called by the finding thread, which helps out when the others do not keep up.
    /// \return false if no more graphs are wanted
    bool put(const Assignment& graph);

    /// Waits for everything that was put.
    /// \return false if not all of it was wanted
    /// \throw what a stage threw
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
    bool wanted_ = true; ///< what the finding thread knows of `ended_`
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Batch> waiting_;
    std::size_t taken_ = 0; ///< batches
    bool closing_ = false;
    bool ended_ = false; ///< nothing more is wanted
    std::exception_ptr failure_;
    std::vector<std::jthread> helpers_;
};

} // namespace qm
