%
O0001
(rule: F 2.3 G50 S beside other codes)
(expect: #1=500)
(expect: to X10)
G99G50S2000
G97S500M3
G50S1500M8
#1=#4119
G00X20.
M30
%
