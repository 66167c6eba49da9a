%
O00001
(rule: Haas alarm 303: the end is not on the circle)
(expect: to X0 Y0)
(expect: alarm 303 K5220 at 7:15)
G00 X0. Y0.
G02 X10. Y10. I5. J0. F200.
M30
%
