%
O0001
(rule: F 3.7 G68 without R: No.5410, which is 0 as delivered)
(expect: to X5 Y0)
G68X0Y0
G00X5.
G69
M30
%
