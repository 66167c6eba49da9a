%
O0001
(rule: F 1.3 No.3403#6 AD2 = 0: the last word of an address and the last G code of a group act)
(expect: to X2 line)
(expect: to X5 rapid)
G00G01X1.X2.F100.
G01G00X5.
M30
%
