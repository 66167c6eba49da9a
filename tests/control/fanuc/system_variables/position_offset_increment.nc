%
O0001
(rule: F 6.5 ... and so is what an offset is taken from)
(expect: #100=1)
(expect: #101=1)
G10L2P1X0.1
G54G00X0.2
IF[#5041EQ0.2]THEN#100=1
IF[#5021EQ0.3]THEN#101=1
M30
%
