%
O0001
(rule: F 11 PS0315: G76 knows tools of 80, 60, 55, 30, 29 and 0 degrees)
(expect: alarm PS0315 K5253 at 8:1)
G99 G97 S500 M03
G00 X30. Z2.
G76 P021045 Q100 R0.05
G76 X18. Z-30. P1000 Q500 F2.
M30
%
