%
O0001
(rule: F 5.6 G71: dU below 0 and a start inside: a bore)
(expect: path X18Z2 X17.6Z2.1 X21.6 z-19.9f0.2 x20.6z-19.4 Z2.1 X25.6 z-19.9 x24.6z-19.4 Z2.1 X29.6 z-19.9 x28.6z-19.4 Z2.1)
(expect: path X33.6 z-15.9 x32.6z-15.4 Z2.1 X37.6 z-11.9 x36.6z-11.4 Z2.1 X39.6 z-9.9 x29.6z-19.9 x19.6 X18Z2)
G99 G97 S500 M03
G00 X18. Z2.
G71 U2. R0.5
G71 P10 Q20 U-0.4 W0.1 F0.2
N10 G00 X40.
G01 Z-10.
X30. Z-20.
N20 X20.
M30
%
