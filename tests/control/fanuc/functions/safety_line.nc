%
O0001
(rule: F 7 the safety line cancels groups 07 08 09 16 11 17)
(expect: to X1)
G40G49G80G50G69G15G17G21G90G94
X1.
M30
%
