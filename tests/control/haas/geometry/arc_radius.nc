%
O00001
(rule: Haas G03: R above 0 is the shorter arc)
(expect: to X0 Y0)
(expect: to X10 Y10)
G00 X0. Y0.
G03 X10. Y10. R10. F200.
M30
%
