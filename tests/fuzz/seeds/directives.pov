#version 3.7;
#declare A = 3; #local B = <1, 2, 3>;
#ifdef (A) #declare C = A*2 + 1; #else #error "no" #end
#ifndef (Z) #declare Z = -1.5e-2; #end
#if (A > 2 & C != 7 | !0) #declare D = 1; #elseif (A) #declare D = 2; #end
#switch (A) #case (1) #declare E = 1; #break #range (2, 4) #declare E = 2; #break #else #declare E = 3; #end
#while (A > 0) sphere { <A, 0, 0>, 0.3 } #declare A = A - 1; #end
#for (I, 0, 4, 2) box { <I, 0, 0>, <I + 1, 1, 1> } #end
#undef B
#debug concat("C = ", str(C, 0, 3), " ", vstr(3, <1, 2, 3>, ", ", 0, 1), "\n")
#warning "odd"
