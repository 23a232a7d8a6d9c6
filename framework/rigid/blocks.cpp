// SPDX-License-Identifier: MIT
#include "rigid/blocks.hpp"

#include <algorithm>
#include <tuple>

namespace rigor {

namespace {

constexpr std::size_t bodies_of_a_block = 96;
constexpr int most_halvings = 5;

// The parts are numbered as in a heap: 1 is the whole, 2k and 2k + 1 the halves of k.
class Partition {
public:
    Partition(const ContactProblem& problem, std::vector<int> bodies, int times)
        : problem_(problem), bodies_(std::move(bodies)), part_of_(problem.bodies.size(), 0)
    {
        const Vector3d up = problem.up().cwiseAbs();
        up.maxCoeff(&vertical_);
        halve(0, bodies_.size(), 1, times);
    }

    // The smallest part that holds both bodies; a static body is in all.
    int part_of(int body1, int body2) const
    {
        int a = part_of_[body1], b = part_of_[body2];
        if (a == 0 || b == 0) return std::max(a, b);
        while (a != b) {
            a /= 2;
            b /= 2;
        }
        return a;
    }

private:
    void halve(std::size_t first, std::size_t last, int part, int times)
    {
        if (times == 0) {
            for (std::size_t k = first; k < last; ++k)
                part_of_[bodies_[k]] = part;
            return;
        }
        const int axis = widest(first, last), across = 3 - axis - vertical_;
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [&](int i) {
            const Vector3d& X = problem_.bodies[i].position;
            return std::tuple(X[axis], X[vertical_], X[across], i);
        };
        const auto begin = bodies_.begin();
        std::nth_element(
            begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
            begin + static_cast<std::ptrdiff_t>(last), [&](int i, int j) { return at(i) < at(j); });
        halve(first, middle, 2 * part, times - 1);
        halve(middle, last, 2 * part + 1, times - 1);
    }

    int widest(std::size_t first, std::size_t last) const
    {
        Vector3d low = problem_.bodies[bodies_[first]].position, high = low;
        for (std::size_t k = first; k < last; ++k) {
            low = low.cwiseMin(problem_.bodies[bodies_[k]].position);
            high = high.cwiseMax(problem_.bodies[bodies_[k]].position);
        }
        Vector3d extent = high - low;
        extent[vertical_] = -1;
        int axis = 0;
        extent.maxCoeff(&axis);
        return axis;
    }

    const ContactProblem& problem_;
    std::vector<int> bodies_, part_of_;
    int vertical_ = 1;
};

} // namespace

void split_into_blocks(const ContactProblem& problem, Island& island)
{
    int times = 0;
    while (times < most_halvings && (island.bodies.size() >> (times + 1)) >= bodies_of_a_block)
        ++times;
    const int parts = 2 << times;
    const int n = static_cast<int>(island.pairs.size());
    island.blocks = {{0, n}};
    island.stages = {{0, 1}};
    if (times == 0) return;

    // by part, the smallest parts first: 2^times and up, then 2^(times-1) and up ... 1
    const Partition partition(problem, island.bodies, times);
    const auto place = [&](int part) {
        int first = 1; // of the parts as small as this one
        while (2 * first <= part)
            first *= 2;
        return parts - 2 * first + (part - first);
    };
    std::vector<int> places(n), ends(parts - 1, 0);
    for (int k = 0; k < n; ++k) {
        const SolvedContact& c = problem.contacts[island.pairs[k].first];
        places[k] = place(partition.part_of(c.body1, c.body2));
        ++ends[places[k]];
    }
    island.blocks.clear();
    int first = 0;
    for (int& end : ends) {
        island.blocks.push_back({first, first + end});
        first += end;
        end = island.blocks.back().first;
    }
    std::vector<ContactPair> pairs(n);
    for (int k = 0; k < n; ++k)
        pairs[ends[places[k]]++] = island.pairs[k];
    island.pairs = std::move(pairs);
    island.stages.clear();
    for (int size = parts / 2, begin = 0; size > 0; begin += size, size /= 2)
        island.stages.push_back({begin, begin + size});
}

} // namespace rigor
