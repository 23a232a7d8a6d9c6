// SPDX-License-Identifier: MIT
#include "slips.hpp"

namespace rigor::slips {

namespace {

std::string function(const Place& place, const std::string& body)
{
    return "namespace rigor {\n" + place.result + " " + place.name + "(" + place.parameters +
           ")\n{\n" + body + "\n}\n}\n";
}

// The right answer, from the definition that was given another name.
std::string right(const Place& place)
{
    return "    return " + right_call(place) + ";";
}

const std::string blank = "    return {};";

} // namespace

std::string right_call(const Place& place)
{
    std::string arguments, word;
    for (const char c : place.parameters + ",") {
        const bool is_name = std::string(" ,&").find(c) == std::string::npos;
        if (is_name) word += c;
        if (c == ',') arguments += (arguments.empty() ? "" : ", ") + word;
        if (!is_name) word.clear();
    }
    return "right_" + place.name + "(" + arguments + ")";
}

const std::vector<Place>& places_of_slips()
{
    static const std::vector<Place> places = {
        {"pipeline", "double", "kinetic_energy",
         "double mass, const Vector3d& velocity, const Matrix3d& inertia, "
         "const Vector3d& angular_velocity",
         ""},
        {"kinematics", "Vector3d", "world_point",
         "const Matrix3d& R, const Vector3d& X, const Vector3d& p", "cross_matrix"},
        {"inertia", "MassProperties", "solid_sphere", "double density, double radius",
         "world_inertia"},
        {"rotation", "Quaternion", "conjugate", "const Quaternion& q", "multiply"},
        {"collision", "Body", "apply_impulse",
         "const Body& body, const Vector3d& x, const Vector3d& j", "sample_level_set"},
        {"contact", "double", "contact_restitution", "int k, int n", "contact_levels"},
        {"plasticity", "Matrix3d", "deviator", "const Matrix3d& stress", "von_mises_principal"},
        {"fracture", "PrincipalStress", "principal_stress", "const Matrix3d& stress",
         "closest_face"},
        {"validation", "Judgement", "test_tangent", "const Tangent& tangent", "test_spring_force"},
    };
    return places;
}

const std::vector<Slip>& all_slips()
{
    using P = const Place&;
    using Text = const std::string&;
    static const std::vector<Slip> slips = {
        {"missing", Cost::its_task, [](P) { return std::string(); }},
        {"renamed", Cost::its_task,
         [](P p) {
             Place other = p;
             other.name += "_2";
             return function(other, blank);
         }},
        {"one_parameter_more", Cost::its_task,
         [](P p) {
             Place other = p;
             other.parameters += ", int again";
             return function(other, blank);
         }},
        {"outside_the_namespace", Cost::its_task,
         [](P p) {
             return "using namespace rigor;\n" + p.result + " " + p.name + "(" + p.parameters +
                    ")\n{\n" + blank + "\n}\n";
         }},
        {"static_function", Cost::its_task,
         [](P p) { return "namespace rigor {\nnamespace {\n" + function(p, blank) + "}\n}\n"; }},
        {"stub", Cost::its_task,
         [](P p) { return function(p, "    throw NotImplemented(\"" + p.name + "\");"); }},
        {"no_return", Cost::its_task, [](P p) { return function(p, ""); }},
        {"endless_loop", Cost::its_task,
         [](P p) { return function(p, "    for (volatile int i = 0;; i = i + 1) {}"); }},
        {"endless_recursion", Cost::its_task,
         [](P p) {
             return "static volatile int depth;\nstatic int deeper(int n)\n{\n    depth = n;\n"
                    "    return deeper(n + 1) + depth;\n}\n" +
                    function(p, "    if (deeper(0) != 7) throw 1;\n" + blank);
         }},
        {"abort", Cost::its_task, [](P p) { return function(p, "    std::abort();"); }},
        {"exit", Cost::its_task, [](P p) { return function(p, "    std::exit(0);"); }},
        {"throw", Cost::its_task, [](P p) { return function(p, "    throw 42;"); }},
        {"exception", Cost::its_task,
         [](P p) { return function(p, "    std::vector<int>().at(3);\n" + blank); }},
        {"null_pointer", Cost::its_task,
         [](P p) {
             return function(p,
                             "    int* volatile nothing = nullptr;\n    *nothing = 1;\n" + blank);
         }},
        {"out_of_bounds", Cost::its_task,
         [](P p) {
             return function(p, "    std::vector<double> v(3);\n    volatile long i = 1L << 40;\n"
                                "    v[i] = 1;\n" +
                                    blank);
         }},
        {"division_by_zero", Cost::its_task,
         [](P p) {
             return function(p, "    volatile int zero = 0;\n    if (1 / zero == 3) throw 1;\n" +
                                    blank);
         }},
        {"output_without_end", Cost::its_task,
         [](P p) { return function(p, "    for (;;) std::puts(\"here\");"); }},
        {"memory_without_end", Cost::its_task,
         [](P p) {
             return function(p, "    std::vector<std::vector<double>> v;\n"
                                "    for (;;) v.emplace_back(1 << 20, 1.0);");
         }},
        {"nan", Cost::its_task,
         [](P p) {
             return function(p, "    " + p.result +
                                    " value;\n    std::memset(static_cast<void*>"
                                    "(&value), 0xff, sizeof value);\n    return value;");
         }},
        {"asks_for_input", Cost::its_task,
         [](P p) {
             return function(
                 p,
                 "    int typed = 0;\n    if (std::scanf(\"%d\", &typed) < 1) throw 1;\n" + blank);
         }},
        {"helper_without_body", Cost::its_task,
         [](P p) {
             return "double lost(double);\n" +
                    function(p, "    if (lost(1) < 2) throw 1;\n" + blank);
         }},
        {"own_main", Cost::nothing,
         [](P p) {
             return function(p, right(p)) + "int main() { std::puts(\"a try\"); return 0; }\n";
         }},
        {"names_of_ours", Cost::nothing,
         [](P p) {
             return function(p, right(p)) +
                    "namespace rigor {\nint worker() { return 1; }\nint run_worker(bool) { return "
                    "1; "
                    "}\nvoid scene() {}\n}\nextern \"C\" void rigor_run_scenes() {}\nint data;\n";
         }},
        {"prints", Cost::nothing,
         [](P p) { return function(p, "    std::puts(\"\\033[31m here\");\n" + right(p)); }},
        {"empty_file", Cost::its_file, nullptr, [](Text) { return std::string(); }},
        {"syntax_error", Cost::its_file, nullptr, [](Text text) { return text + "int x = ;\n"; }},
        {"missing_brace", Cost::its_file, nullptr,
         [](Text text) { return text + "namespace rigor {\n"; }},
        {"unknown_header", Cost::its_file, nullptr,
         [](Text text) { return "#include \"my_matrix.h\"\n" + text; }},
        {"not_text", Cost::its_file, nullptr,
         [](Text) {
             return std::string("\x7f"
                                "ELF\0\1\2\3",
                                8);
         }},
        {"includes_itself", Cost::its_file, nullptr,
         [](Text text) { return "#include __FILE__\n" + text; }},
        {"template_without_end", Cost::its_file, nullptr,
         [](Text text) { return text + "template <int n> struct S : S<n + 1> {};\nS<0> s;\n"; }},
        {"crash_before_main", Cost::its_file, nullptr,
         [](Text text) {
             return text + "#include <cstdlib>\nstatic int early = (std::abort(), 1);\n";
         }},
        {"loop_before_main", Cost::its_file, nullptr,
         [](Text text) {
             return text + "static int late = [] { for (volatile int i = 0;; i = i + 1) {} "
                           "return 1; }();\n";
         }},
        {"byte_order_mark", Cost::nothing, nullptr,
         [](Text text) { return "\xef\xbb\xbf" + text; }},
        {"windows_lines", Cost::nothing, nullptr,
         [](Text text) {
             std::string lines;
             for (const char c : text)
                 lines += c == '\n' ? "\r\n" : std::string(1, c);
             return lines;
         }},
    };
    return slips;
}

} // namespace rigor::slips
