// SPDX-License-Identifier: MIT
// The random cases of a property, each with a seed that a failure names.
//
//     for (Random random : seeds(100)) {
//         const Matrix3d R = random.rotation();
#pragma once

#include "support/catch.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace rigor::testing {

/// n seeds in a row. The seed of the running case is in the verdict, and in the message of every
/// failure, where `CAPTURE(seed)` would put it.
class Seeds {
public:
    Seeds(unsigned first, unsigned n) : first_(first), n_(n) {}

    class Iterator {
    public:
        Iterator(Seeds& seeds, unsigned seed) : seeds_(&seeds), seed_(seed) {}
        unsigned operator*() const
        {
            seeds_->begin_case(seed_);
            return seed_;
        }
        Iterator& operator++()
        {
            ++seed_;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return seed_ != other.seed_; }

    private:
        Seeds* seeds_;
        unsigned seed_;
    };
    Iterator begin() { return {*this, first_}; }
    Iterator end() { return {*this, first_ + n_}; }

private:
    void begin_case(unsigned seed);

    unsigned first_, n_;
    std::optional<Catch::ScopedMessage> message_; // shows the seed of the running case
};

/// The seeds of a property, n in a row from the run's first seed.
Seeds seeds(unsigned n);

/// The first seed of every property: 0, or the run's `--seed`, or the one that `draw_first_seed`
/// draws.
unsigned first_seed();
void set_first_seed(unsigned seed);

/// A number that follows from the first seed and from `number`, for draws that a submission sees.
/// To try all first seeds takes longer than a submission may run, so it cannot compute the first
/// seed from what it sees, nor another such number.
std::uint64_t one_way(unsigned number);

/// Draws the first seed of the test that begins, if the run has a key of secret seeds.
void draw_first_seed(const std::string& test);
/// @param key  see `seeds/drawn_seed.hpp`; empty for none
void set_seed_key(std::string key);

} // namespace rigor::testing
