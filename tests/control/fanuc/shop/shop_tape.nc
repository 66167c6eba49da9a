%
 O 0114 (SPACES)
(rule: F 1.1, 1.4, 1.6: blanks in words, skips, comments, increments, dwells)
(expect: path X10Y-5 X20 x40f100 y5 x0.5y-0.5 x0.1)
(expect: dwell 1.5)
(expect: dwell 1.5)
(expect: dwell 1.5)
(skip: 2)
N1 G 9 0 G 5 4 G 0 X 1 0 . Y - 5 .
/N2 X 20.
/2 N3 X 30.
N4 G01 (FEED) X 40. (END) F 1 0 0 (MM)
N5 Y+5.
N6X.5Y-.5
N7 X100
N8 G04 P1500
N9 G4 X1.5
N10 G4 X1500
M3 0
%
