#include "enumerate/optimum/search_tree.h"

#include <gtest/gtest.h>

namespace qm::test {
namespace {

Decision about(int variable) {
    return {VariableId(variable), Decision::About::value, ArcState::in};
}

TEST(SearchTree, LeadsFromTheRootToEveryNode) {
    SearchTree tree;
    const auto root = tree.add({}, {});
    const auto left = tree.add(root, about(1));
    const auto right = tree.add(root, about(2));
    const auto below = tree.add(left, about(3));
    EXPECT_EQ(tree.size(), 4U);
    EXPECT_TRUE(tree.isRoot(root));
    EXPECT_FALSE(tree.isRoot(right));
    EXPECT_TRUE(tree.path(root).empty());
    const auto path = tree.path(below);
    ASSERT_EQ(path.size(), 2U);
    EXPECT_EQ(path[0].variable, VariableId(1));
    EXPECT_EQ(path[1].variable, VariableId(3));
}

TEST(SearchTree, HandsOutTheLowestBoundAndThenTheYoungest) {
    SearchTree tree;
    const auto root = tree.add({}, {});
    const auto dear = tree.add(root, about(1));
    const auto old = tree.add(root, about(2));
    const auto young = tree.add(root, about(3));
    tree.open(dear, 2);
    tree.open(young, 1);
    tree.open(old, 1);
    for (const auto expected : {young, old, dear}) {
        ASSERT_FALSE(tree.allClosed());
        EXPECT_EQ(tree.next().node, expected);
        tree.closeNext();
    }
    EXPECT_TRUE(tree.allClosed());
    tree.open(dear, 2);
    tree.closeAll();
    EXPECT_TRUE(tree.allClosed());
}

} // namespace
} // namespace qm::test
