%
O0001
(rule: F 5.6, 6.2: variables in the shape count as they are when it is read)
(expect: path X30Z2 X26 z-10f0.2 x27z-9.5 Z2 X22 z-10 x23z-9.5 Z2 X20 z-10 x30 Z2)
G99 G97 S500 M03
#1=20
#2=10
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G00 X#1
#2=#2+0
G01 Z-#2
N20 X30.
M30
%
