%
O0001
(rule: F 5.2 No.5103#0 SIJ: the shift of G76 by I and J)
(expect: to Z20)
(expect: to X10 Z20)
(expect: to X10 Z2)
(expect: to X10 Z-5)
(expect: to X9.5 Y0.2 Z-5)
(expect: to X9.5 Y0.2 Z2)
(expect: to X9.5 Y0.2 Z20)
(expect: to X10 Y0 Z20)
(expect: to X15 Z20)
(expect: to X15 Z2)
(expect: to X15 Z-5)
(expect: to X14.5 Y0.2 Z-5)
(expect: to X14.5 Y0.2 Z2)
(expect: to X14.5 Y0.2 Z20)
(expect: to X15 Y0 Z20)
G00X0Y0Z20.S1000M3
G76X10.Y0Z-5.R2.I-0.5J0.2F100
X15.
G80
M30
%
