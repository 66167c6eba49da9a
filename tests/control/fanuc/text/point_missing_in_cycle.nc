%
O0001
(rule: case 7: Z and R of a cycle, a corner, a shift and a radius lose their points as positions do)
(expect: warning K5902 at 9:8)
(expect: warning K5902 at 9:11)
(expect: warning K5902 at 11:4)
(expect: warning K5902 at 12:13)
T1M6S1000M3
G81X10.Z-5R2F100
G80
G52X5
G1X20.Y0F100,R2
Y20.
M30
%
