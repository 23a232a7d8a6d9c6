// SPDX-License-Identifier: MIT
// The name that is most like a misspelt word, by the edit distance of Damerau (1964). The distance
// is computed by dynamic programming, with one row of the table for each letter of the word. The
// name with the smallest distance wins. If too many letters differ everywhere, the name wins that
// begins with the word.
#include "errors/nearest.hpp"

#include "errors/quotes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace rigor {

namespace {

// Longest word that is compared [bytes]. A longer one is not a misspelt name, and would only cost
// time.
constexpr std::size_t longest_word = 64;

// Number of letters to insert, remove, replace or swap with a neighbor to turn one word into the
// other.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before, previous(b.size() + 1), current(b.size() + 1);
    std::iota(previous.begin(), previous.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], before[j - 2] + 1);
        }
        before = std::exchange(previous, current);
    }
    return previous[b.size()];
}

// The only name that begins with this word, or empty.
std::string_view completed(std::string_view word, std::span<const std::string_view> names)
{
    constexpr std::size_t fewest_letters = 3; // fewer are the beginning of too many names
    if (word.size() < fewest_letters) return {};
    std::string_view found;
    for (const std::string_view name : names) {
        if (!name.starts_with(word)) continue;
        if (!found.empty()) return {};
        found = name;
    }
    return found;
}

} // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> names)
{
    std::string_view best;
    if (word.size() > longest_word) return best;
    std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const std::string_view name : names) {
        const std::size_t distance = edit_distance(word, name);
        if (distance >= best_distance || distance >= std::max(word.size(), name.size())) continue;
        best = name;
        best_distance = distance;
    }
    return best.empty() ? completed(word, names) : best;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> names,
                       std::string_view otherwise)
{
    const std::string_view near = nearest(word, names);
    if (!near.empty()) return "; did you mean " + in_quotes(near) + "?";
    return otherwise.empty() ? std::string() : "; " + std::string(otherwise);
}

std::string suggestion(std::string_view word, std::span<const std::string> names,
                       std::string_view otherwise)
{
    const std::vector<std::string_view> views(names.begin(), names.end());
    return suggestion(word, views, otherwise);
}

} // namespace rigor
