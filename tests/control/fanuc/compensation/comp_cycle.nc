%
O0001
(rule: F 4.3, 5 no block of a cycle is lost: called in the mode it is an alarm)
(expect: to X0 Y-20 Z10)
(expect: to X0 Y-5)
(expect: alarm  K5284 at 13:1)
G10L12P1R5.
G17G90G40
M3S1000
G00X0.Y-20.Z10.
G42D1G01X0.Y0.F200.
X20.
G81X30.Z-5.R2.
G80
G40Y-20.
M30
%
