%
O0001
(rule: F 3.6 G12.1: the face begins where C stands, recommended is 0; C counts on behind it)
(machine: driven)
(expect: warning K5547 at 11:1)
(expect: to X20 C30 rapid)
(expect: to X0 Y20 C120)
(expect: to X20 C120 rapid)
G98 G97 S1000 M3
G00 X40. C30.
G12.1
G01 X0 C20. F200
G13.1
G00 X40.
M30
%
