%
O00001
(rule: Haas G10: L2 work offsets, L20 additional ones, L10 and L11 length and wear, P the number)
(expect: to X8 Y2)
(expect: to X-1 Y0)
(expect: #1=-2)
G10 L2 P1 X-2. Y2.
G10 L20 P1 X-1.
G10 L10 P1 R50.
G10 L11 P1 R0.5
G54
S500 M03
G00 X10. Y0
#1=#5221
G154 P1
G00 X0 Y0
M30
%
