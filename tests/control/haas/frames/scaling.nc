%
O00001
(rule: Haas G51: P is the factor, G50 ends it)
(expect: to X20 Y10)
(expect: to X10 Y5)
G51 P2.
G00 X10. Y5.
G50
X10. Y5.
M30
%
