%
O0001
(rule: F 6.8 L0 is no count of passes)
(expect: alarm  K5438 at 5:7)
M98P12L0
M30
%
