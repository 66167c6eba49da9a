%
O0001
(rule: F 1.1 a subprogram without M99)
(expect: alarm PS5010 K5474 at 10:1)
(expect: called 6:1)
M98P2
M30
O0002
#100=1
%
