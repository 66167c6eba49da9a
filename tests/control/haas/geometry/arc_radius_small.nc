%
O00001
(rule: Haas alarm 302: R does not reach)
(expect: to X0 Y0)
(expect: alarm 302 K5221 at 7:10)
G00 X0. Y0.
G02 X10. R2. F200.
M30
%
