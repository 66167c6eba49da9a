%
O00001
(rule: Haas G02: I and J from the start of the arc)
(expect: to X0 Y0)
(expect: to X10 Y10)
G00 X0. Y0.
G02 X10. Y10. I10. J0. F200.
M30
%
