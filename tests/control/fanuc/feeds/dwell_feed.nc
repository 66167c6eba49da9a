%
O0001
(rule: F 12: the time of a dwell stands behind X or P; the habits of a SINUMERIK change the feed and the speed)
(expect: warning K5908 at 10:1)
(expect: warning K5908 at 11:1)
(expect: to X10 F200)
(expect: to X20 F2)
M3S500
G1X10.F200
G04F2.
G4S5
G04
X20.
M30
%
