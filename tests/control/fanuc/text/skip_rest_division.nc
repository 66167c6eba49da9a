%
O0001
(rule: F 1.4 behind a variable the sign would be a division)
(expect: alarm  K5018 at 6:7)
#1=4
G00X#1/2
M30
%
