%
O00001
(rule: the time of a dwell may stand behind U and X; no axis moves)
(expect: dwell 1.5)
(expect: dwell 2)
(expect: path )
G04U1.5
G04X2.
M30
%
