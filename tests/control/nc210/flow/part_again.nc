%
;rule: NC-210 12: (EPP,A,B) executes the part between two labels once, and goes on behind
;expect: path X10 x20f100 X10 x20 X0
G90 G94 F100. S1000 M3
"A1"
G0 X10.
G1 X20.
"A2"
(EPP,A1,A2)
G0 X0
M30
