%
O0001
(rule: F 2.5 G92 S limits the speed; S stays)
(expect: #1=100)
G96S100M3
G92S2000
#1=#4119
M30
%
