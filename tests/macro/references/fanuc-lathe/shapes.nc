%
O0001
G00 X100. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.2
(    ^ leads: 9:1)
(        ^ leads: 12:1)
(    ^ as: repeat)
N10 G00 X20.
( ^ uses: 5:6 [9:1] 14:6 15:6)
G01 Z-20.
N20 X100.
( ^ is: block 20)
G70 P10 Q20
G70 P10 Q70
(        ^ leads: missing)
M30
%
