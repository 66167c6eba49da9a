%
O0001
(rule: F 6.5 inputs without a value are 0, and told; real programs read them all the time, cases/fanuc.md 14)
(expect: warning K5950 at 6:4)
(expect: #1=0)
#1=#1000
M30
%
