%
O0001
(rule: F 3.4 older controls write parameters by L50; G10 L3 P1 and P2 add and replace data of tool lives)
(expect: path X10)
(expect: warning K5577 at 9:6)
(expect: warning K5578 at 12:1)
G00X10.
G10L50
N5042R1
G11
G10L3P1
P1L500Q1
G11
G10L3P2
P1
G11
M30
%
