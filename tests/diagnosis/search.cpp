// SPDX-License-Identifier: MIT
// The search tries the simplest relations first: of the wrong answers to the right ones, to the
// right ones for changed arguments, to the arguments, and combinations of these. If nothing holds
// for all inputs, it looks for the inputs on which the answers are wrong.
#include "diagnosis/search.hpp"

#include "diagnosis/matches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor::diagnosis {

namespace {

// What one or several places of the answer are, in words.
struct Clause {
    std::vector<int> roles;
    std::string words; // "twice the right one"
    std::string advice;
};
using Clauses = std::vector<Clause>;

class Search {
public:
    Search(const Evidence& evidence, const Ask& student)
        : evidence_(evidence), student_(student), changed_(evidence),
          features_(features(evidence.arguments))
    {
        for (int role = 0; role < static_cast<int>(evidence.answer.roles.size()); ++role)
            roles_.push_back(role);
    }

    std::optional<Finding> on_drawn();
    std::optional<Finding> on_special();

private:
    Cases wrong_of(const Cases& cases) const;
    std::vector<int> wrong_roles(const Cases& cases) const;
    Clauses explained(const Cases& cases);
    std::optional<Clause> by_shape(const Cases& cases) const;
    std::optional<Clause> by_one_change(const Cases& cases, const std::vector<int>& roles);
    std::optional<Clause> by_two_changes(const Cases& cases);
    std::optional<Clause> by_related(const Cases& cases);
    Clauses by_places(const Cases& cases);
    std::string from_answers(const Pairs& pairs) const;
    std::optional<Finding> by_condition(const Cases& cases, bool needs_clauses);
    std::optional<Finding> by_no_effect(const Cases& cases);
    std::optional<Finding> by_part(const Cases& cases);
    std::optional<std::size_t> effect(int role, const Cases& cases, const Ask& ask,
                                      bool is_student) const;
    std::string subject(const std::vector<int>& roles) const;
    std::string sentence(const Clauses& clauses, const std::string& where) const;

    const Evidence& evidence_;
    const Ask& student_;
    ChangedAnswers changed_;
    std::vector<Feature> features_;
    std::vector<int> roles_;
};

Cases Search::wrong_of(const Cases& cases) const
{
    Cases wrong;
    for (const Case* c : cases)
        if (c->is_different()) wrong.push_back(c);
    return wrong;
}

std::vector<int> Search::wrong_roles(const Cases& cases) const
{
    std::vector<int> wrong;
    for (const int role : roles_)
        if (std::any_of(cases.begin(), cases.end(), [role](const Case* c) {
                return c->agreement[role] == Agreement::different;
            }))
            wrong.push_back(role);
    return wrong;
}

// "Your answer", or "`inertia` of your answer".
std::string Search::subject(const std::vector<int>& roles) const
{
    if (roles.size() == roles_.size() || evidence_.answer.roles[roles[0]].name.empty())
        return "your answer";
    std::string text;
    for (const int role : roles)
        text += (text.empty() ? "`" : ", `") + evidence_.answer.roles[role].name + "`";
    return text + " of your answer";
}

std::string Search::sentence(const Clauses& clauses, const std::string& where) const
{
    std::string text, advice;
    for (const Clause& clause : clauses) {
        const bool is_one = clause.roles.size() == roles_.size() || clause.roles.size() == 1;
        text += fmt::format("{}{}{} {}", text.empty() ? "" : "; ", subject(clause.roles),
                            is_one ? " is" : ": each is", clause.words);
        if (advice.empty()) advice = clause.advice;
    }
    text += where + (advice.empty() ? "" : ": " + advice) + ".";
    if (text[0] != '`') text[0] = static_cast<char>(std::toupper(text[0]));
    return text;
}

// An answer where there should be none, or none where there should be one.
std::optional<Clause> Search::by_shape(const Cases& cases) const
{
    const auto count = [](const Value& value) {
        return value.sizes.empty() ? std::uint64_t{1} : value.sizes[0];
    };
    const auto all = [&](auto predicate) {
        return std::all_of(cases.begin(), cases.end(), predicate);
    };
    const bool is_optional = evidence_.answer.encoding.form == Form::optional;
    if (all([&](const Case* c) { return count(c->answer) == 0 && count(c->right) != 0; }))
        return Clause{roles_, is_optional ? "none although there is one" : "empty", ""};
    if (all([&](const Case* c) { return count(c->answer) != 0 && count(c->right) == 0; }))
        return Clause{roles_, "a value although there is none", ""};
    return {};
}

std::optional<Clause> Search::by_one_change(const Cases& cases, const std::vector<int>& roles)
{
    for (std::size_t t = 0; t < changed_.all().size(); ++t)
        if (changed_.explains(t, cases, roles)) {
            const Transform& change = changed_.all()[t];
            return Clause{changed_.explains(t, cases, roles_) ? roles_ : roles,
                          "the right one for " + change.words, change.advice};
        }
    return {};
}

std::optional<Clause> Search::by_related(const Cases& cases)
{
    for (std::size_t t = 0; t < changed_.all().size(); ++t)
        if (const std::string words = changed_.related(t, cases, roles_); !words.empty())
            return Clause{roles_, words + " for " + changed_.all()[t].words, ""};
    return {};
}

std::optional<Clause> Search::by_two_changes(const Cases& cases)
{
    constexpr std::size_t most = 120; // changes to combine, the simplest ones
    const std::size_t n = std::min(most, changed_.all().size());
    for (std::size_t first = 0; first < n; ++first)
        for (std::size_t second = 0; second < n; ++second)
            if (first != second && changed_.explains(first, second, cases, roles_))
                return Clause{roles_,
                              fmt::format("the right one for {} and {}",
                                          changed_.all()[first].words,
                                          changed_.all()[second].words),
                              ""};
    return {};
}

std::string Search::from_answers(const Pairs& pairs) const
{
    const std::string words = plain_relation(pairs);
    return words.empty() ? argument_itself(pairs, evidence_.arguments) : words;
}

// An explanation for each wrong place by itself.
Clauses Search::by_places(const Cases& cases)
{
    Clauses clauses;
    for (const int role : wrong_roles(cases)) {
        const Pairs pairs = pairs_of(evidence_.answer, role, cases);
        Clause clause = {{role}, from_answers(pairs), ""};
        if (clause.words.empty())
            if (const auto change = by_one_change(cases, {role})) clause = *change;
        if (clause.words.empty())
            clause.words = relation_to_arguments(pairs, evidence_.arguments, features_);
        if (clause.words.empty()) return {};
        if (!clauses.empty() && clauses.back().words == clause.words)
            clauses.back().roles.push_back(role);
        else
            clauses.push_back(clause);
    }
    return clauses;
}

Clauses Search::explained(const Cases& cases)
{
    if (const auto clause = by_shape(cases)) return {*clause};
    const bool same_shape =
        std::all_of(cases.begin(), cases.end(), [](const Case* c) { return c->is_same_shape(); });
    const std::vector<int> wrong = wrong_roles(cases);
    if (same_shape) {
        Clauses clauses;
        for (const int role : wrong) {
            const std::string words = from_answers(pairs_of(evidence_.answer, role, cases));
            if (words.empty() || (!clauses.empty() && clauses[0].words != words)) break;
            if (clauses.empty()) clauses.push_back({{}, words, ""});
            clauses[0].roles.push_back(role);
        }
        if (!clauses.empty() && clauses[0].roles == wrong) return clauses;
    }
    if (const auto clause = by_one_change(cases, wrong)) return {*clause};
    if (!same_shape) return {};
    if (Clauses clauses = by_places(cases); !clauses.empty()) return clauses;
    if (const auto clause = by_related(cases)) return {*clause};
    if (const auto clause = by_two_changes(cases)) return {*clause};
    return {};
}

std::optional<Finding> Search::by_condition(const Cases& cases, bool needs_clauses)
{
    Cases wrong = wrong_of(cases), right;
    for (const Case* c : cases)
        if (c->is_same()) right.push_back(c);
    constexpr std::size_t enough_right = 8;
    if (wrong.size() < enough || right.size() < enough_right) return {};
    const std::string condition = condition_of(evidence_.arguments, wrong, right);
    if (condition.empty()) return {};
    const Clauses clauses = explained(wrong);
    if (needs_clauses && clauses.empty()) return {};
    if (clauses.empty())
        return Finding{Finding::Sort::condition,
                       fmt::format("Your answer is wrong where {}, and only there.", condition)};
    return Finding{Finding::Sort::condition,
                   sentence(clauses, fmt::format(" where {}, and right elsewhere", condition))};
}

// In how many cases an answer changes if this place of the arguments gets other numbers. Nothing
// if that cannot be asked.
std::optional<std::size_t> Search::effect(int role, const Cases& cases, const Ask& ask,
                                          bool is_student) const
{
    const Role& what = evidence_.arguments.roles[role];
    std::size_t changes = 0;
    for (std::size_t i = 0; i + 1 < cases.size(); ++i) {
        Value changed = cases[i]->arguments;
        const auto ours = evidence_.arguments.leaves(changed, role),
                   theirs = evidence_.arguments.leaves(cases[i + 1]->arguments, role);
        if (ours.size() != 1 || theirs.size() != 1) return {};
        const auto other = cases[i + 1]->arguments.of(theirs[0], what);
        std::copy(other.begin(), other.end(), changed.of(ours[0], what).begin());
        const auto answer = ask(changed);
        if (!answer) return {};
        const Value& before = is_student ? cases[i]->answer : cases[i]->right;
        changes += !agree(evidence_.answer, before, *answer, cases[i]->noise);
        if (is_student && changes > 0) break;
    }
    return changes;
}

std::optional<Finding> Search::by_no_effect(const Cases& cases)
{
    for (int role = 0; role < static_cast<int>(evidence_.arguments.roles.size()); ++role) {
        // A count of iterations may change nothing on these inputs and matter on others.
        const Role& what = evidence_.arguments.roles[role];
        if (what.in_list || what.form == Form::integer) continue;
        if (effect(role, cases, student_, true) != std::size_t{0}) continue;
        const auto right = effect(role, cases, evidence_.reference, false);
        if (!right || *right < cases.size() / 2) continue;
        return Finding{Finding::Sort::no_effect, fmt::format("Your answer does not depend on `{}`.",
                                                             evidence_.arguments.roles[role].name)};
    }
    return {};
}

std::optional<Finding> Search::by_part(const Cases& cases)
{
    const std::vector<int> wrong = wrong_roles(cases);
    std::string part;
    if (wrong.size() == 1) {
        part = right_part(pairs_of(evidence_.answer, wrong[0], cases));
        if (part.empty() && roles_.size() > 1) part = "wrong, and the rest of it is right";
    }
    if (part.empty()) return {};
    return Finding{Finding::Sort::part, sentence({{wrong, part, ""}}, "")};
}

std::optional<Finding> Search::on_drawn()
{
    Cases cases;
    for (const Case& c : evidence_.cases)
        if (c.is_drawn) cases.push_back(&c);
    if (wrong_of(cases).size() < enough) return {};
    const Clauses clauses = explained(cases);
    if (!clauses.empty())
        return Finding{Finding::Sort::relation,
                       sentence(clauses, fmt::format(", on all {} random inputs", cases.size()))};
    if (auto found = by_condition(cases, false)) return found;
    if (auto found = by_no_effect(cases)) return found;
    return by_part(cases);
}

std::optional<Finding> Search::on_special()
{
    Cases cases;
    for (const Case& c : evidence_.cases)
        cases.push_back(&c);
    return by_condition(cases, false);
}

// Answers in single precision: nearly all have a relative error of about 1e-7.
std::optional<Finding> single_precision(const Evidence& evidence)
{
    constexpr double most = 3e-6;
    std::size_t inexact = 0, n = 0;
    for (const Case& c : evidence.cases) {
        if (!c.is_drawn) continue;
        if (!c.is_same_shape() || !close(c.right.numbers, c.answer.numbers, most)) return {};
        inexact += !close(c.right.numbers, c.answer.numbers, rounding);
        ++n;
    }
    if (n == 0 || inexact < enough || 4 * inexact < 3 * n) return {};
    return Finding{Finding::Sort::relation,
                   "Your answer is right to about 7 digits only: there may be a `float` in place "
                   "of a `double`."};
}

} // namespace

std::optional<Finding> explain(const Evidence& evidence, const Ask& student)
{
    if (auto found = single_precision(evidence)) return found;
    Search search(evidence, student);
    if (auto found = search.on_drawn()) return found;
    return search.on_special();
}

} // namespace rigor::diagnosis
