%
O0001
(rule: F 3.4 G52: per axis, absolute, G91 does not count; G52 X0 Y0 cancels)
(expect: to X11)
(expect: to X12 Y7)
(expect: to X3 Y3)
G52X10.
X1.
G91G52Y5.
G90X2.Y2.
G52X0Y0
X3.Y3.
M30
%
