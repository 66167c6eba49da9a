%
O0001
(rule: F 5.2 G76 turns the spindle behind the hole, not before it)
(expect: warning K5213 at 7:1)
(expect: path Z20 X20 Z2 z-5f60 X21 Z2 Z20 X20)
G00X0Y0Z20.S1000
G98G76X20.Z-5.R2.Q1.F60
G80
M30
%
