// SPDX-License-Identifier: MIT
#include "grading/class/known_results.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"

namespace rigor {

std::string KnownResults::grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                                const OnGraded& on_graded, const OnWait& on_wait)
{
    const auto files_of = [&](std::size_t i) {
        return result_files_in(known_.result_of(work.submissions[i].name).parent_path());
    };
    std::vector<std::size_t> known, others;
    for (const std::size_t i : numbers) {
        const std::optional<Row> row = known_.row_of(work.submissions[i].name);
        const bool is_known =
            row && row->fingerprint == work.fingerprints[i] && !known_.has_unconfirmed();
        (is_known ? known : others).push_back(i);
    }
    if (!others.empty() && !engine_)
        throw InputError("expected what --regrade has shown, found another test, another "
                         "submission or no result, such as that of " +
                         in_quotes(work.submissions[others[0]].name) +
                         ": --regrade alone shows what would change now");
    for (const std::size_t i : known)
        on_graded(i, files_of(i));
    return others.empty() ? "" : engine_->grade(work, others, on_graded, on_wait);
}

} // namespace rigor
