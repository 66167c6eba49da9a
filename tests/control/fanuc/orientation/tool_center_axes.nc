%
O0001
(rule: F 4.7 G43.4: words of rotary axes are their places, X Y Z the tip on the part; G49: the control point is where the axes hold it)
(machine: five-axis)
(expect: to X0 Y0 Z0)
(expect: to X10 Y5 Z0 A0 C0)
(expect: to X10 Y5 Z0 A45 C90 axes)
(expect: to X30 Y5 Z0 A45 C90)
(expect: to X7 Y20.384776 Z2.325902 A45 C90)
(expect: to X7 Y20.384776 Z2.325902 A45 C90)
T1M06
S1000M03
G43.4H1
G01X10.Y5.Z0F500.
A45.C90.
X30.
G49
G91X0
M30
%
