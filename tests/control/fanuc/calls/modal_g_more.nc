%
O0001
(rule: F 6.5 every group of modal codes that the manual lists)
(expect: #1=22)
(expect: #2=80)
(expect: #3=50)
(expect: #4=67)
(expect: #5=69)
(expect: #6=15)
(expect: #7=40.1)
(expect: #8=50.1)
(expect: #11=81)
(expect: #12=51)
(expect: #13=66)
(expect: #14=68)
(expect: #15=16)
(expect: #18=51.1)
#1=#4004
#2=#4009
#3=#4011
#4=#4012
#5=#4016
#6=#4017
#7=#4018
#8=#4022
S1000M3
G81X5.Z-5.R2.F100
#11=#4009
G80
G51.1X0
#18=#4022
G50.1X0
G51X0Y0Z0P1000
#12=#4011
G50
G66P9100
#13=#4012
G67
G68X0Y0R10.
#14=#4016
G69
G16
#15=#4017
G15
M30
O9100
M99
%
