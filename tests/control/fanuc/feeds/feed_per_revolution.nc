%
O0001
(rule: F 3.2 G95 waits for a spindle that stands)
(expect: alarm  K5214 at 5:1)
G95G01X10.F0.1
M30
%
