%
O0001
(rule: F 12 at X0Y0: G68 X10 Y0 R90, then G91 X20: about where the tool is)
(expect: to X0 Y20)
G68X10.Y0R90.
G91X20.Y0
M30
%
