%
O0001
(rule: F 3.4 G10 L3 to G11: T inside calls no tool)
(expect: warning K5578 at 7:1)
(expect: path X100)
G10L3
P1L500Q1
T0303
G11
G00X100.
M30
%
