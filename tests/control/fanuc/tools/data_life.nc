%
O0001
(rule: F 3.4 G10 L3 to G11: data of tool lives are read and have no effect; T inside selects no tool)
(expect: warning K5578 at 7:1)
(expect: path X10)
G10L3
P1L500Q1
T5H1D1
G11
G00X10.
M30
%
