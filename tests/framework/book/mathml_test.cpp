// SPDX-License-Identifier: MIT
#include "book/mathml.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"

using rigor::InputError;
using rigor::book::mathml;

namespace {

// The content of the formula.
std::string inner(const std::string& latex)
{
    const std::string whole = mathml(latex, false), start = "<math><mrow>", end = "</mrow></math>";
    REQUIRE(whole.starts_with(start));
    REQUIRE(whole.ends_with(end));
    return whole.substr(start.size(), whole.size() - start.size() - end.size());
}

} // namespace

TEST_CASE("book: atoms of a formula", "[book]")
{
    CHECK(inner("x = 2.5") == "<mi>x</mi><mo>=</mo><mn>2.5</mn>");
    CHECK(inner(R"(\omega \times -L)") ==
          "<mi>ω</mi><mo>×</mo><mo form=\"prefix\">−</mo><mi>L</mi>");
    CHECK(inner(R"(\mathrm{Tr} < 1)") ==
          "<mi mathvariant=\"normal\">Tr</mi><mo>&lt;</mo><mn>1</mn>");
    CHECK(mathml("x", true) == "<math display=\"block\"><mrow><mi>x</mi></mrow></math>");
}

TEST_CASE("book: indices and exponents belong to the atom before them", "[book]")
{
    CHECK(inner("x_i^2") == "<msubsup><mi>x</mi><mi>i</mi><mn>2</mn></msubsup>");
    CHECK(inner(R"(R^T)") == "<msup><mi>R</mi><mi>T</mi></msup>");
    CHECK(inner(R"(I_{ab})") == "<msub><mi>I</mi><mrow><mi>a</mi><mi>b</mi></mrow></msub>");
    CHECK(inner(R"(\dot q)") == "<mover accent=\"true\"><mi>q</mi><mo>˙</mo></mover>");
}

TEST_CASE("book: fractions take single digits, roots take groups", "[book]")
{
    CHECK(inner(R"(\tfrac12)") == "<mfrac><mn>1</mn><mn>2</mn></mfrac>");
    CHECK(inner(R"(\frac{a}{b})") ==
          "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac>");
    CHECK(inner(R"(\sqrt3)") == "<msqrt><mn>3</mn></msqrt>");
}

TEST_CASE("book: brackets grow where the formula says so", "[book]")
{
    CHECK(inner("(x)") == "<mo stretchy=\"false\">(</mo><mi>x</mi><mo stretchy=\"false\">)</mo>");
    CHECK(inner(R"(\left( x \right))") == "<mo>(</mo><mi>x</mi><mo>)</mo>");
    CHECK(inner(R"(\lvert x \rvert)") == "<mo stretchy=\"false\" form=\"prefix\">|</mo><mi>x</mi>"
                                         "<mo stretchy=\"false\" form=\"postfix\">|</mo>");
}

TEST_CASE("book: a sign without a left side stands close to what it belongs to", "[book]")
{
    const std::string minus = "<mo form=\"prefix\">−</mo><mn>1</mn>",
                      infix = "<mo>−</mo><mn>1</mn>";
    const std::string open = "<mo stretchy=\"false\">(</mo>",
                      close = "<mo stretchy=\"false\">)</mo>";
    CHECK(inner("-1") == minus);
    CHECK(inner("(-1, -1)") == open + minus + "<mo>,</mo>" + minus + close);
    CHECK(inner("(x) - 1") == open + "<mi>x</mi>" + close + infix);
    CHECK(inner("x' - 1") == "<mi>x</mi><mo>′</mo>" + infix);
    CHECK(inner(R"(\lvert x \rvert - 1)").ends_with("|</mo>" + infix));
}

TEST_CASE("book: the name of a function stands apart from letters and close to brackets", "[book]")
{
    const std::string space = "<mspace width=\"0.17em\"/>";
    CHECK(inner(R"(2 \arctan x)") ==
          "<mn>2</mn>" + space + "<mi>arctan</mi>" + space + "<mi>x</mi>");
    CHECK(inner(R"(\cos\theta)") == "<mi>cos</mi>" + space + "<mi>θ</mi>");
    CHECK(inner(R"(\exp(t))") == "<mi>exp</mi>" + inner("(t)"));
    CHECK(inner(R"(\det = 1)") == "<mi>det</mi><mo>=</mo><mn>1</mn>");
}

TEST_CASE("book: words in a formula stand apart from letters", "[book]")
{
    CHECK(inner(R"(a \text{ or } b)") == "<mi>a</mi><mtext>\u00A0or\u00A0</mtext><mi>b</mi>");
    CHECK(inner(R"(\text{where})") == "<mtext>where</mtext>");
}

TEST_CASE("book: an assignment is one sign, and a quotient stands together", "[book]")
{
    CHECK(inner(R"(V \mathrel{+}= j/M)") ==
          "<mi>V</mi><mo>+=</mo><mi>j</mi><mo lspace=\"0\" rspace=\"0\">/</mo><mi>M</mi>");
    CHECK(inner(R"(\underbrace{F}_0)") ==
          "<munder><munder><mrow><mi>F</mi></mrow><mo>⏟</mo></munder><mn>0</mn></munder>");
}

TEST_CASE("book: a matrix has rows and cells", "[book]")
{
    CHECK(inner(R"(\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix})") ==
          "<mrow><mo>(</mo><mtable>"
          "<mtr><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mrow><mn>2</mn></mrow></mtd></mtr>"
          "<mtr><mtd><mrow><mn>3</mn></mrow></mtd><mtd><mrow><mn>4</mn></mrow></mtd></mtr>"
          "</mtable><mo>)</mo></mrow>");
}

TEST_CASE("book: what it does not know is named", "[book]")
{
    REQUIRE_THROWS_AS(mathml(R"(\frobnicate x)", false), InputError);
    REQUIRE_THROWS_AS(mathml(R"(\frac{a)", false), InputError);
    REQUIRE_THROWS_AS(mathml("x_", false), InputError);
    REQUIRE_THROWS_AS(mathml(R"(\mathrm{s^2})", false), InputError);
    REQUIRE_THROWS_AS(mathml(R"(x \mathrel{+} y)", false), InputError);
    REQUIRE_THROWS_AS(mathml(R"(\begin{cases} 1 \end{cases})", false), InputError);
}
