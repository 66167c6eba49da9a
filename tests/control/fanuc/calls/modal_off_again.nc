%
O0001
(rule: F 6.5 the codes that end a mode are read back behind it)
(expect: #1=69)
(expect: #2=50)
(expect: #3=15)
(expect: #4=80)
(expect: #5=67)
S1000M3
G68X0Y0R10.
G69
#1=#4016
G51X0Y0Z0P1000
G50
#2=#4011
G16
G15
#3=#4017
G81X5.Z-5.R2.F100
G00X0
#4=#4009
#5=#4012
M30
%
