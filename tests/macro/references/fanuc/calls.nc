%
O0100(CALLS)
M98 P0200
(     ^ leads: 29:2)
(     ^ as: call)
M98 P30012
(       ^ leads: O0012.NC:2:2)
M98 P0200 Q50
(          ^ leads: 31:1)
M98 P200 L3
(    ^ is: program 200)
G65 P0012 A1. B#1
(     ^ leads: O0012.NC:2:2)
G66 P200
G67
G66.1 P12 A3.
X1. Y2.
G67
M98 P#2
(   ^ leads: computed)
M98 P77
(    ^ leads: missing)
M98<PART_17>
(   ^ leads: PART_17:2:2)
M198 P12
(     ^ leads: O0012.NC:2:2)
N30 M30
( Those who call the program have the block)
O0200(SUB)
( ^ uses: 3:6 8:6 10:6 14:6 [29:2])
N50 G01 X1. F100.
M99 P30
(    ^ leads: 27:1)
%
