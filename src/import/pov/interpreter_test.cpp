// SPDX-License-Identifier: Apache-2.0
#include "import/pov/interpreter.h"

#include <gtest/gtest.h>

#include "import/pov/pov_language_test.h"

namespace sundog::pov {
namespace {

// Every rule of the language that the small programs name, each told by what it prints.
TEST(PovInterpreter, DeclarationsAndScopes) {
    EXPECT_EQ(printed("#declare A = 1; #macro M() #local A = 2; #declare B = A; #end M() #debug str(A*10+B,0,0)"),
              "12");
    // #declare within a macro assigns to the innermost declaration, new names are global.
    EXPECT_EQ(
        printed("#macro M() #local A = 2; N() #debug str(A,0,0) #end #macro N() #declare A = 7; #declare G = 5; #end "
                "M() #debug str(G,0,0) #ifdef(A) #debug \"A\" #end"),
        "75");
    // By reference: an identifier alone; an expression is not.
    EXPECT_EQ(printed("#macro Inc(P) #declare P = P + 1; #end #declare X = 1; Inc(X) Inc(+X) #debug str(X,0,0)"), "2");
    EXPECT_EQ(
        printed("#macro Swap(A, B) #local T = A; #declare A = B; #declare B = T; #end #declare A = 1; #declare B = 2; "
                "Swap(B, A) #debug str(A*10+B,0,0)"),
        "21");
    EXPECT_EQ(
        printed("#declare V = array[2]{1, 2} #macro Inc(P) #declare P = P + 1; #end Inc(V[1]) #debug str(V[1],0,0)"),
        "3");
    // A #local whose value a macro gives is of the caller's level, even if the macro's text goes on.
    EXPECT_EQ(printed("#macro F() #if (1) 3; #end #end #macro G() #local N = F() #debug str(N,0,0) #end G()"), "3");
    EXPECT_EQ(printed("#declare A = 1; #undef A #ifndef(A) #debug \"gone\" #end"), "gone");
}

// A missing semicolon makes a directive see the value from before it.
TEST(PovInterpreter, DirectivesBehindADeclarationWait) {
    EXPECT_EQ(printed("#declare A = 5 #declare B = A; #debug str(B,0,0)"), "5");
    EXPECT_EQ(printed("#declare I = 0; #while (I < 3) #declare I = I + 1 #end #debug str(I,0,0)"), "3");
    EXPECT_EQ(printed("#if (1) #declare A = 1 #else #declare A = 2 #end #debug str(A,0,0)"), "1");
    EXPECT_EQ(printed("#declare A = #if (0) 7 #else 8 #end; #debug str(A,0,0)"), "8");
}

// Wrong branches, loops that run once too often, clauses that don't fall through (POV-Ray: they do).
TEST(PovInterpreter, ConditionalsAndLoops) {
    EXPECT_EQ(printed("#for (I, 0, 1, 0.25) #debug str(I,0,2) #debug \" \" #end #debug str(I,0,2)"),
              "0.00 0.25 0.50 0.75 1.00 1.25");
    EXPECT_EQ(printed("#for (I, 3, 1, -1) #debug str(I,0,0) #end"), "321");
    EXPECT_EQ(printed("#for (I, 1, 9) #if (I = 4) #break #end #debug str(I,0,0) #end #debug \"e\""), "123e");
    EXPECT_EQ(printed("#switch (1) #case (1) #debug \"a\" #case (2) #debug \"b\" #range (0,3) #debug \"c\" #else "
                      "#debug \"d\" #end"),
              "abcd");
    EXPECT_EQ(
        printed("#switch (2) #case (1) #debug \"a\" #break #range (2,3) #debug \"b\" #break #else #debug \"c\" #end"),
        "b");
    EXPECT_EQ(printed("#switch (9) #case (1) #debug \"a\" #break #else #debug \"c\" #end #debug \"e\""), "ce");
    EXPECT_EQ(printed("#if (0) #debug \"a\" #elseif (1) #debug \"b\" #elseif (1) #debug \"c\" #else #debug \"d\" #end"),
              "b");
    EXPECT_EQ(printed("#macro M() #debug \"a\" #if (1) #break #end #debug \"b\" #end M() #debug \"c\""), "ac");
    EXPECT_EQ(printed("#if (0) #while (1) #end #macro X() #end \"#else\" #else #debug \"y\" #end"), "y");
}

// Numbers as povray 3.7 prints them for the same expressions.
TEST(PovInterpreter, Expressions) {
    EXPECT_EQ(evaluated("-2*3-1"), "-7");
    EXPECT_EQ(evaluated("2 - -3"), "5");
    EXPECT_EQ(evaluated("(2>1 | 0 & 0)"), "0");
    EXPECT_EQ(evaluated("(1 < 2 ? 3 : 4)"), "3");
    // Catches loops that end a step too early: sums of tenths that fall just short of 1 are less than 1, and equal 1.
    EXPECT_EQ(evaluated("(1 - 1e-12 < 1 ? 3 : 4)"), "3");
    EXPECT_EQ(evaluated("(1 - 1e-12 = 1 ? 3 : 4)"), "3");
    EXPECT_EQ(evaluated("(1 - 1e-12 >= 1 ? 3 : 4)"), "3");
    EXPECT_EQ(evaluated("<1,2,3>.z + y.y"), "4");
    EXPECT_EQ(evaluated("<1,2> + <1,2,3>"), "<2, 4, 3>");
    EXPECT_EQ(evaluated("(1 < 2) + (<1,2,3> = <3,2,1>)"), "<1, 2, 1>");
    EXPECT_EQ(evaluated("!<1,0,3>"), "<0, 1, 0>");
    EXPECT_EQ(evaluated("<1 2 3,>"), "<1, 2, 3>");
    EXPECT_EQ(evaluated("mod(-7,3)*100 + div(-7,3)*10 + int(-2.5)"), "-122");
    EXPECT_EQ(evaluated("select(-1,1,2)*100 + select(0,1,2)*10 + select(0,1,2,3)"), "122");
    EXPECT_EQ(evaluated("vcross(x,y)"), "<0, 0, 1>");
    EXPECT_EQ(evaluated("min(3,1,2) + max(1,5)"), "6");
    EXPECT_EQ(evaluated("(\"abc\" < \"abd\") + (\"a\" = \"b\")"), "1");
    EXPECT_EQ(evaluated("bitwise_xor(12,10)"), "6");
}

// Colours as povray 3.7 prints them.
TEST(PovInterpreter, Colors) {
    EXPECT_EQ(evaluated("rgb <1,2,3>*0.5+0.1"), "rgbft <0.6, 1.1, 1.6, 0, 0>");
    EXPECT_EQ(evaluated("color <1,2,3>"), "rgbft <1, 2, 3, 0, 0>");
    EXPECT_EQ(evaluated("color 0.5"), "rgbft <0.5, 0.5, 0.5, 0.5, 0.5>");
    EXPECT_EQ(evaluated("color red 1 green 0.5 + 1"), "rgbft <1, 1.5, 0, 0, 0>");
    EXPECT_EQ(evaluated("rgbt <1,2,3,4>"), "rgbft <1, 2, 3, 0, 4>");
    EXPECT_EQ(evaluated("rgbf 0.5"), "rgbft <0.5, 0.5, 0.5, 0.5, 0>");
    EXPECT_EQ(evaluated("rgb <1,2,3> filter 0.5"), "rgbft <1, 2, 3, 0.5, 0>");
    EXPECT_EQ(evaluated("rgb C*2", "#declare C = rgbft <.1,.2,.3,.4,.5>;"), "rgbft <0.2, 0.4, 0.6, 0.8, 1>");
    EXPECT_EQ(evaluated("C green 1", "#declare C = rgbft <.1,.2,.3,.4,.5>;"), "rgbft <0.1, 1, 0.3, 0.4, 0.5>");
    EXPECT_EQ(evaluated("C.gray", "#declare C = rgb <1,0,0>;"), "0.297");
    EXPECT_EQ(evaluated("srgb <1,0,1>"), "rgbft <1, 0, 1, 0, 0>");
}

TEST(PovInterpreter, Strings) {
    EXPECT_EQ(printed("#debug concat(str(123.456,-9,3), str(5,3,0), str(1.5,0,-1))"), "00123.456  51.500000");
    EXPECT_EQ(printed("#debug vstr(3,<1,2>,\", \",0,1)"), "1.0, 2.0, 0.0");
    EXPECT_EQ(printed("#debug concat(strlwr(\"AbC\"), strupr(\"abc\"), substr(\"ABCDEFGHI\",4,2), chr(70))"),
              "abcABCDEF");
    EXPECT_EQ(evaluated("val(\"1.5e2\") + strlen(\"abc\") + asc(\"A\") + strcmp(\"a\",\"b\")"), "217");
    EXPECT_EQ(printed("#debug datetime(0)"), "2000-01-01 00:00:00Z");
}

// rand() that differs from POV-Ray's moves everything that scenes place by it.
TEST(PovInterpreter, RandomStreamsAreThoseOfPovRay) {
    EXPECT_EQ(printed("#declare S = seed(0); #debug concat(str(rand(S),0,9), \" \", str(rand(S),0,9))"),
              "0.000002874 0.466563685");
    EXPECT_EQ(printed("#declare A = seed(0); #declare S = seed(2); #debug str(rand(S),0,9)"), "0.843982876");
}

// Values of povray 3.7 at the same parameters.
TEST(PovInterpreter, Splines) {
    const std::string spline =
        "#declare S = spline { cubic_spline 0,<0,0,0> 1,<1,2,3> 2,<4,0,1> 3.5,<5,5,5> 4,<0,0,0> }";
    EXPECT_EQ(printed(spline + "#debug vstr(3, S(1.4), \" \", 0, 3)"), "2.168 1.232 2.336");
    EXPECT_EQ(printed(spline + "#debug vstr(3, S(3.7), \" \", 0, 3)"), "5.000 5.000 5.000");
    EXPECT_EQ(printed(spline + "#debug vstr(3, S(1.7, quadratic_spline), \" \", 0, 3)"), "2.890 1.020 2.125");
    EXPECT_EQ(printed(spline + "#debug vstr(3, S(2.7, natural_spline), \" \", 0, 3)"), "6.503 3.581 4.065");
    EXPECT_EQ(printed(spline + "#debug vstr(3, S(0.5, linear_spline), \" \", 0, 3)"), "0.500 1.000 1.500");
}

TEST(PovInterpreter, Arrays) {
    EXPECT_EQ(evaluated("dimensions(A)*100 + dimension_size(A,2)*10 + A[1][2]",
                        "#declare A = array[2][3] {{1,2,3},{4,5,6},}"),
              "236");
    // Assigned by value: the copy keeps what it was.
    EXPECT_EQ(evaluated("B[0]*10 + A[0]", "#declare A = array[1]{1} #declare B = A #declare A[0] = 2;"), "12");
    EXPECT_EQ(evaluated("A[1][0]", "#declare A = array[2]{array[1]{3}, array[2]{4,5}}"), "4");
    EXPECT_EQ(printed("#declare A = array[2] #declare A[1] = \"s\"; #ifndef (A[0]) #debug A[1] #end"), "s");
}

TEST(PovInterpreter, MacrosAnywhere) {
    EXPECT_EQ(evaluated("2*M(3)+1", "#macro M(A) (A*10) #end"), "61");
    EXPECT_EQ(formatted("#macro Inside() <1,2,3>, 4 pigment { #end sphere { Inside() rgb 1 } }"),
              "sphere {\n  <1, 2, 3>, 4\n  pigment { rgbft <1, 1, 1, 0, 0> }\n}\n");
    EXPECT_EQ(evaluated("Fib(10)", "#macro Fib(N) #if (N < 2) N #else (Fib(N-1) + Fib(N-2)) #end #end"), "55");
    // VMD and ASE leave out commas.
    EXPECT_EQ(evaluated("M(<1,2,3> 4)", "#macro M(A, B) A*B #end"), "<4, 8, 12>");
}

TEST(PovInterpreter, UserFunctions) {
    const auto value = [](const std::string& function, const std::string& call) {
        return evaluated(call, "#declare C = 3; #declare V = <1,2,3>; #declare F = function" + function + ";");
    };
    EXPECT_EQ(value("(a, b) { a + b*2 }", "F(1, 2)"), "5");
    EXPECT_EQ(value(" { u + y*V.z }", "F(1, 2, 3)"), "7");
    EXPECT_EQ(value("(x) { -x*2 + 3*-x }", "F(2)"), "-10");
    EXPECT_EQ(value("(x) { sum(i, 1, x, i*i) + prod(i, 1, x, i) }", "F(3)"), "20");
    EXPECT_EQ(value("(x) { (x>1) & (x<C) | !x }", "F(2)*10 + F(3)"), "10");
    EXPECT_EQ(value("(x) { select(x, 1, 2, 3) + min(x, 1, 0) + pow(2, C) }", "F(0)"), "10");
    EXPECT_EQ(value(" { transform { rotate x*90 translate y } }", "F(1, 2, 3).y"), "-2");
    EXPECT_EQ(evaluated("G(4)", "#declare F = function(x) { x*2 } #declare G = function(a) { F(a + 1) - F(1) }"), "8");
}

TEST(PovInterpreter, ConditionsAndValuesOfTheOptions) {
    PovOptions options;
    options.clock.clock = 0.25;
    options.clock.frame_number = 7;
    options.width = 64;
    options.declarations = {{"Given", 2.5}, {"Name", std::string("n")}};
    EXPECT_EQ(
        printed("#debug concat(str(clock,0,2), str(frame_number,0,0), str(image_width,0,0), str(Given,0,1), Name)",
                options),
        "0.257642.5n");
    options.version = 370;
    EXPECT_EQ(printed("#debug str(version,0,1) #version 3.5; #debug str(version,0,1)", options), "3.73.5");
}

}  // namespace
}  // namespace sundog::pov
