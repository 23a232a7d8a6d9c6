// SPDX-License-Identifier: MIT
// Divides a large island into blocks for several threads. The code first sorts the moving bodies
// into vertical slabs along the island's longest horizontal extent. Then it groups the pairs by the
// slabs of their bodies: within one slab, between two neighboring slabs, or farther apart. Blocks
// that share no moving body get the same color (graph coloring) and can be swept at the same time.
#include "rigid/contact/blocks.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

// A large island is divided into 3 or 7 slabs with the same number of bodies, and one slab at each
// end with half of that number. If the two end slabs count as one, there are 4 or 8 slabs, so two
// or four threads get equal shares of the bodies. There are 4 or 8 borders between slabs. After the
// slabs, the threads share the pairs across every second border, then those across the remaining
// borders. So they get equal numbers of borders too.
//
// The least number of bodies in a slab, where the two end slabs count as one. Smaller slabs would
// let threads share smaller islands, but more pairs would lie between two slabs. Chosen by trial;
// `bench pile` shows how much time a second thread saves.
constexpr std::size_t bodies_of_a_slab = 48;
// A quarter of the largest number of slabs, where the two end slabs count as one. Eight slabs are
// enough for four threads; with more slabs, more pairs would lie between two slabs.
constexpr int most_fours = 2;

// The slab of each body of an island. The slabs lie side by side along the longest horizontal
// extent of the island. All have the same number of bodies, except the first and the last slab,
// which have half that number. `fours` is a quarter of the number of slabs, where the first and the
// last slab count as one.
class Slabs {
public:
    Slabs(const ContactProblem& problem, std::span<const int> bodies, int fours)
        : slab_of_(problem.bodies.size(), -1), halves_(8 * fours)
    {
        const int axis = longest(problem, bodies);
        sorted_.reserve(bodies.size());
        for (int i : bodies) {
            const Vector3d& X = problem.bodies[i].position;
            sorted_.push_back({X[axis], X[(axis + 1) % 3], X[(axis + 2) % 3], i});
        }
        divide(0, halves_);
    }

    // The index of the slab in which a body of the island lies; -1 for a static body.
    int of(int body) const { return slab_of_[body]; }

private:
    struct SortedBody {
        double along, across1, across2; // position along the row of slabs and across it [m]
        int body;

        friend bool operator<(const SortedBody& a, const SortedBody& b)
        {
            if (a.along != b.along) return a.along < b.along;
            return std::tie(a.across1, a.across2, a.body) < std::tie(b.across1, b.across2, b.body);
        }
    };

    // The axis of the longest horizontal extent.
    static int longest(const ContactProblem& problem, std::span<const int> bodies)
    {
        Vector3d low = problem.bodies[bodies[0]].position, high = low;
        for (int i : bodies) {
            low = low.cwiseMin(problem.bodies[i].position);
            high = high.cwiseMax(problem.bodies[i].position);
        }
        int vertical = 1, axis = 0;
        problem.up().cwiseAbs().maxCoeff(&vertical);
        Vector3d extent = high - low;
        extent[vertical] = -1;
        extent.maxCoeff(&axis);
        return axis;
    }

    // Sorts the bodies into the half slabs [first, last). The half slabs 2i - 1 and 2i form slab i;
    // the first and the last slab consist of one half only.
    void divide(int first, int last)
    {
        const auto at = [&](int half) {
            const auto n = static_cast<std::ptrdiff_t>(sorted_.size());
            return sorted_.begin() + n * half / halves_;
        };
        if (last - first > 1) {
            const int middle = first + (last - first) / 2;
            std::nth_element(at(first), at(middle), at(last));
            divide(first, middle);
            divide(middle, last);
            return;
        }
        for (auto sorted = at(first); sorted != at(last); ++sorted)
            slab_of_[sorted->body] = (first + 1) / 2;
    }

    std::vector<int> slab_of_;
    std::vector<SortedBody> sorted_;
    int halves_;
};

} // namespace

std::vector<ContactPair> split_into_blocks(const ContactProblem& problem, Island& island)
{
    const int n = static_cast<int>(island.pairs.size());
    const std::size_t most = island.bodies.size() / (4 * bodies_of_a_slab);
    const int fours = static_cast<int>(std::min<std::size_t>(most, most_fours));
    island.blocks = {{0, n}};
    island.colors = {{0, 1}};
    if (fours == 0) return {};

    // The bodies are divided into slabs, which are layers of space. The order of the blocks: first
    // one block for each slab, with the pairs whose moving bodies lie in this slab. Then come the
    // blocks of the pairs between slabs 2i and 2i + 1, then those of the pairs between slabs 2i + 1
    // and 2i + 2. The last block holds all other pairs.
    const Slabs slabs(problem, island.bodies, fours);
    const int count = 4 * fours + 1, even = count, odd = even + count / 2, far = odd + count / 2;
    const auto block_of = [&](const ContactPair& pair) {
        const ContactConstraint& c = problem.contacts[pair.first];
        const int a = slabs.of(c.body1), b = slabs.of(c.body2);
        const int low = std::min(a, b), high = std::max(a, b);
        if (low < 0 || low == high) return high;
        if (high - low > 1) return far;
        return (low % 2 == 0 ? even : odd) + low / 2;
    };
    std::vector<int> blocks(n), next(far + 1, 0);
    for (int k = 0; k < n; ++k)
        ++next[blocks[k] = block_of(island.pairs[k])];
    island.blocks.clear();
    int first = 0;
    for (int& size : next) {
        island.blocks.push_back({first, first + size});
        first += std::exchange(size, first);
    }
    std::vector<ContactPair> pairs(n);
    for (int k = 0; k < n; ++k)
        pairs[next[blocks[k]]++] = island.pairs[k];
    island.colors = {{0, even}, {even, odd}, {odd, far}, {far, far + 1}};
    return std::exchange(island.pairs, std::move(pairs));
}

} // namespace rigor
