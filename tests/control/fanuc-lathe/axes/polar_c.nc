%
O0001
(rule: F 3.6 G12.1, G112 on a lathe: X a diameter, C a length in radius, I and J in X-C; C turns)
(machine: driven)
(expect: to X20 C0 rapid)
(expect: to X20 Y0 C0 F200)
(expect: to X10 Y10 C45)
(expect: to X-10 Y10 C135 ccw I0 J10)
(expect: to X-10 Y0 C180)
(expect: to X30 Y0 C180 rapid)
(expect: to X30 C0 rapid)
G98 G97 S1000 M3
G00 X40. Z2. C0
G12.1
G01 X40. F200
X20. C10.
G03 X-20. C10. I-10. J0
G01 C0
G13.1
G00 X60.
C0
M30
%
