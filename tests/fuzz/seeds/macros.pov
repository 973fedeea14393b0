#version 3.7;
#macro Ring(N, R, What)
  #local I = 0;
  union {
    #while (I < N) object { What translate R*x rotate I*360/N*y } #local I = I + 1; #end
  }
#end
#macro Deep(N) #if (N > 0) Deep(N - 1) #else 1 #end #end
#macro Set(V) #declare V = 5; #end
#declare Ball = sphere { 0, 0.2 pigment { color rgb <1, 0.5, 0> } }
object { Ring(5, 2, Ball) }
#local Q = 0; Set(Q)
sphere { <Q, Deep(6), 0>, 1 }
