%
O0001
(rule: F 1.6 L of a call has up to eight digits)
(expect: alarm  K5438 at 5:6)
M98P8L123456789
M30
O0008
M99
%
