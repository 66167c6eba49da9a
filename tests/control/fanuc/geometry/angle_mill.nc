%
O0001
(rule: F 3.8 direct drawing: end and angle, two lines)
(expect: to X0 Y0)
(expect: to X30 Y30)
(expect: to X60 Y30)
(expect: to X60 Y50)
S1000M03
G90G00X0Y0
G01X30.,A45.F200.
,A0
X60.Y50.,A90.
M30
%
