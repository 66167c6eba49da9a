%
O0001
(rule: F 7 P beside a function of the builder belongs to it; M96 without a program is no interrupt)
(expect: warning K5247 at 11:3)
(expect: warning K5241 at 9:1)
(expect: warning K5241 at 10:1)
(expect: path X20)

M59P10
M96
T1P5M06
G00X20.
M30
%
