%
O0001
(rule: F 3.4 an offset that does not act is written without effect on what does)
(expect: to X1)
(expect: to X77 Y20)
G54
G10L2P2X76.
G00X1.
G55X1.Y0.
M30
%
