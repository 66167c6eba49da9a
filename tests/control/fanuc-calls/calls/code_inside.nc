%
O0001
(rule: F 6.8 in a program called by a code the codes are plain)
(expect: #100=1)
(expect: to X10 Y0)
(expect: to X10 Z-5)
G81X10.Z-5.R1.
M30
O9012
#100=#100+1
G00X#24
G01Z#26F100
M99
O9020
#100=99
M99
%
