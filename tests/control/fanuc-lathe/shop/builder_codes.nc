%
O0001
(rule: F 7 M6, M96 and M97 are no functions of a lathe's control: the builder's, with the P beside them)
(machine: lathe)
(expect: warning K5241 at 13:1)
(expect: warning K5241 at 14:1)
(expect: warning K5241 at 15:1)
(expect: warning K5241 at 16:1)
(expect: path X20Z2)
(expect: stop)


T0101M06
M96
M97
M59P10
G00X20.Z2.
M00
M30
%
